#include "waywright/map/whale_maps.hpp"

#include <algorithm>

namespace waywright {
namespace {

constexpr double side = 20.0;  // m
constexpr PublishedTask corner_to_corner{{1.5, 1.5}, {18.5, 18.5}};

struct Described {
  const char* name;
  const char* about;
  double optimum;
  std::vector<Box> boxes;
};

const std::vector<Described>& described() {
  static const std::vector<Described> all{
      {"WOA-1", "empty", 24.042, {}},
      {"WOA-2", "unobtrusive", 24.143, {{{4.5, 2}, {6.5, 4}}, {{2, 8}, {4, 10}}, {{9, 8.5}, {11, 10.5}}, {{14, 4.5}, {16, 6.5}}, {{6.5, 14.5}, {8.5, 16.5}}, {{14, 13}, {16, 15}}}},
      {"WOA-3", "narrow passages", 34.563, {{{5, 0}, {5.6, 12.6}}, {{5, 13.8}, {5.6, 20}}, {{10, 0}, {10.6, 5.4}}, {{10, 6.6}, {10.6, 20}}, {{15, 0}, {15.6, 13}}, {{15, 14.2}, {15.6, 20}}}},
      {"WOA-4", "local minima", 29.018, {{{13, 3}, {13.8, 16.6}}, {{3, 15.8}, {13, 16.6}}, {{5, 3}, {13, 3.8}}, {{16.4, 8}, {17.2, 20}}, {{8, 7}, {8.8, 12.6}}}},
      {"WOA-5",
       "cluttered",
       24.597,
       {{{3, 0}, {4.6, 2.6}},       {{6.4, 1.6}, {8.4, 3.6}},    {{0.6, 4.4}, {3, 5.8}},       {{4.4, 4.4}, {6, 7.2}},      {{9.6, 0}, {11, 3}},        {{7.6, 5.2}, {10.4, 6.6}},   {{12.4, 2.2}, {14.2, 5}},
        {{15.8, 1}, {18.6, 3}},     {{11.8, 6.4}, {13.2, 9.4}},  {{0, 8}, {3.6, 9.6}},         {{5.2, 8.8}, {7.8, 10.2}},   {{9.4, 8.2}, {10.6, 11}},   {{15, 5.8}, {17.6, 7.2}},    {{18.4, 5}, {20, 6.4}},
        {{1.6, 11.6}, {3.2, 14.4}}, {{5, 12}, {6.6, 15}},        {{8.2, 12.6}, {11, 14}},      {{12.6, 10.8}, {15.4, 12.4}}, {{17, 9}, {18.6, 12}},      {{0, 16.6}, {2.6, 18}},      {{4.2, 17}, {7, 18.4}},
        {{8.6, 15.8}, {10.2, 18.6}}, {{12.2, 14.2}, {13.8, 17}}, {{15.4, 14.4}, {18.6, 15.8}}, {{11.8, 18.6}, {14.4, 20}},  {{15.8, 17.4}, {17, 20}}}},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& whale_map_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Described& d : described()) all.emplace_back(d.name);
    return all;
  }();
  return names;
}

std::optional<WhaleMap> whale_map(std::string_view name) {
  const auto& all = described();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Described& d) { return d.name == name; });
  if (found == all.end()) return std::nullopt;
  WhaleMap map{found->name, found->about, {}, corner_to_corner, found->optimum};
  map.map.boundaries = {rectangle({0, 0}, {side, side})};
  for (const Box& box : found->boxes) map.map.obstacles.push_back(rectangle(box.low, box.high));
  return map;
}

}  // namespace waywright
