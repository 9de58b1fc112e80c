// What a plan says of the lanes that its scenario was made of.
#include "lane_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"
#include "waywright/io/lane_courses.hpp"

namespace waywright::app {
namespace {

constexpr double least_told = 0.05;             // m, of a stretch
constexpr std::size_t most_named = 3;           // stretches
constexpr std::size_t most_questions = 200'000'000;  // pieces of the way times stretches of lanes

struct Lanes {
  double half = 0.0;  // m
  std::vector<std::pair<Vec2, Vec2>> stretches;
};

std::optional<Lanes> lanes_of(const std::string& meta) {
  const LaneCourses told = lane_courses_of(meta);
  Lanes lanes;
  lanes.half = 0.5 * told.width;
  for (const Polyline& course : told.courses) {
    for (std::size_t i = 0; i + 1 < course.size(); ++i) lanes.stretches.emplace_back(course[i], course[i + 1]);
  }
  if (!(lanes.half > 0.0) || lanes.stretches.empty()) return std::nullopt;
  return lanes;
}

double distance_from(Vec2 p, const std::pair<Vec2, Vec2>& stretch) {
  const Vec2 way = stretch.second - stretch.first;
  const double squared = squared_norm(way);
  const double share = squared > 0.0 ? std::clamp(dot(p - stretch.first, way) / squared, 0.0, 1.0) : 0.0;
  return distance(p, stretch.first + share * way);
}

struct Off {
  Vec2 from{}, to{};
  double length = 0.0;
};

}  // namespace

std::string lanes_sentence(const Plan& plan) {
  if (plan.scenario.meta.empty() || plan.samples.size() < 2) return {};
  const auto lanes = lanes_of(plan.scenario.meta);
  if (!lanes || plan.samples.size() * lanes->stretches.size() > most_questions) return {};
  std::vector<Off> all;
  bool was_off = false;
  for (std::size_t i = 0; i + 1 < plan.samples.size(); ++i) {
    const Sample &a = plan.samples[i], &b = plan.samples[i + 1];
    if (!(b.s > a.s)) continue;
    const Vec2 from = a.pose().position(), to = b.pose().position(), middle = 0.5 * (from + to);
    const bool is_off = std::none_of(lanes->stretches.begin(), lanes->stretches.end(), [&](const auto& stretch) { return distance_from(middle, stretch) <= lanes->half; });
    if (is_off && !was_off) all.push_back({from, {}, 0.0});
    if (is_off) {
      all.back().to = to;
      all.back().length += b.s - a.s;
    }
    was_off = is_off;
  }
  std::erase_if(all, [](const Off& off) { return off.length < least_told; });
  if (all.empty()) return fmt::format("It keeps to the lanes: all of its {:.2f} m lie within {:g} m of their middle.", plan.metrics.length, lanes->half);
  double whole = 0.0;
  for (const Off& off : all) whole += off.length;
  std::stable_sort(all.begin(), all.end(), [](const Off& a, const Off& b) { return a.length > b.length; });
  std::string where;
  for (std::size_t i = 0; i < std::min(all.size(), most_named); ++i) {
    where += fmt::format("{}{:.2f} m from ({:.2f}, {:.2f}) to ({:.2f}, {:.2f})", i == 0 ? "" : ", ", all[i].length, all[i].from.x, all[i].from.y, all[i].to.x, all[i].to.y);
  }
  if (all.size() > most_named) where += fmt::format(" and {} shorter stretch{}", all.size() - most_named, all.size() == most_named + 1 ? "" : "es");
  return fmt::format("{:.2f} m of its {:.2f} m lie off the lanes, farther than {:g} m from their middle: {}. What is free beside lanes may be driven on; map --corridor makes lanes all that is free.", whole,
                     plan.metrics.length, lanes->half, where);
}

void tell_of_lanes(Plan& plan) {
  std::string sentence = lanes_sentence(plan);
  if (sentence.empty()) return;
  plan.explanation.insert(plan.explanation.empty() ? plan.explanation.end() : plan.explanation.end() - 1, std::move(sentence));
}

}  // namespace waywright::app
