#include "waywright/planner/detour_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace waywright {
namespace {

constexpr double same_way = 0.02;         // m
constexpr double least_told = 0.25;       // m, of a way that both have at their ends
constexpr std::size_t most_looked = 4000;  // samples of a way

double distance_from(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double squared = squared_norm(way);
  return distance(p, a + (squared > 0.0 ? std::clamp(dot(p - a, way) / squared, 0.0, 1.0) : 0.0) * way);
}

/// The first sample of the old way from which on it lies on the new one's end, walked backwards on both. The number of samples: none.
std::size_t joins_at(const std::vector<Sample>& old, const std::vector<Sample>& now) {
  std::size_t on = now.size() - 1, joined = old.size();
  for (std::size_t i = old.size(); i-- > 0 && old.size() - i < most_looked;) {
    const Vec2 p = old[i].pose().position();
    // The new way's piece that it lies on is the next one or a few before it.
    std::size_t k = on;
    while (k > 0 && now[on].s - now[k].s < 1.0 && distance_from(p, now[k - 1].pose().position(), now[k].pose().position()) > same_way) --k;
    if (k == 0 || now[on].s - now[k].s >= 1.0) break;
    on = k;
    joined = i;
  }
  return joined;
}

std::string more(double by, const char* unit, int digits, const char* longer, const char* shorter, const char* as_much) {
  const double least = 0.5 * std::pow(10.0, -digits);
  return std::abs(by) < least ? std::string{as_much} : fmt::format("{:.{}f} {} {}", std::abs(by), digits, unit, by > 0.0 ? longer : shorter);
}

}  // namespace

std::vector<std::string> of_part(const char* title, const std::vector<std::string>& sentences) {
  std::vector<std::string> text;
  for (std::string sentence : sentences) {
    if (sentence.starts_with("Proven ") || sentence.empty()) continue;
    // After a colon a sentence goes on, unless its first word is a name (RRT*).
    const bool is_name = sentence.size() > 1 && std::isalpha(static_cast<unsigned char>(sentence[1])) && std::isupper(static_cast<unsigned char>(sentence[1]));
    if (!is_name) sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
    text.push_back(fmt::format("{}: {}", title, sentence));
  }
  return text;
}

std::string detour_sentence(const DrivenWay& old, const DrivenWay& now, double left_at) {
  const auto left = std::find_if(now.samples.begin(), now.samples.end(), [&](const Sample& s) { return s.s >= left_at - 1e-6; });
  const Vec2 from = (left == now.samples.end() ? now.samples.back() : *left).pose().position();
  const double old_length = old.samples.back().s, length = now.samples.back().s;
  std::string text = left_at > least_told ? fmt::format("It leaves the old way after {:.2f} m, at ({:.2f}, {:.2f}), ", left_at, from.x, from.y) : fmt::format("It leaves the old way at once, at ({:.2f}, {:.2f}), ", from.x, from.y);
  const std::size_t joined = joins_at(old.samples, now.samples);
  if (joined < old.samples.size() && old_length - old.samples[joined].s > least_told && old.samples[joined].s > left_at) {
    const Vec2 to = old.samples[joined].pose().position();
    text += fmt::format("and joins it again at ({:.2f}, {:.2f}), {:.2f} m before the end", to.x, to.y, old_length - old.samples[joined].s);
  } else {
    text += "and does not join it again before the end";
  }
  const std::string longer = more(length - old_length, "m", 2, "longer", "shorter", "as long");
  const std::string slower = more(now.time - old.time, "s", 1, "more", "less", "as much time");
  return text + fmt::format(": {} ({:.2f} m in place of {:.2f} m), and it takes {} ({:.1f} s in place of {:.1f} s{}).", longer, length, old_length, slower, now.time, old.time, old.remark);
}

}  // namespace waywright
