#include "waywright/scenario/blocked_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

namespace waywright {
namespace {

constexpr std::size_t most_boxes = 20'000;
constexpr std::size_t most_names = 3;

struct Part {
  Vec2 middle{};
  Vec2 half{};
};

std::string words_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most_names; ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
  return text;
}

}  // namespace

std::optional<Failure> blocked_region(const World& world, const Ring& region, double radius, double required) {
  if (world.empty()) return std::nullopt;
  const Footprint disc{{}, radius};
  const Box box = bounding_box(region);
  std::deque<Part> parts{{0.5 * (box.low + box.high), 0.5 * (box.high - box.low)}};
  std::vector<std::string> names;
  bool is_outside = true;
  for (std::size_t looked_at = 0; !parts.empty(); ++looked_at) {
    if (looked_at == most_boxes) return std::nullopt;
    const Part part = parts.front();
    parts.pop_front();
    const double reach = norm(part.half);
    const Vec2 p = part.middle;
    const bool is_in = contains(region, p);
    if (!is_in && distance(nearest_in(region, p), p) > reach) continue;
    const double edge = world.index().distance(std::span{&p, 1}, radius + required + reach + 1.0);
    const bool is_blocked = world.is_blocked(p);
    if (is_in && !is_blocked && edge >= radius + required && edge > 0.0) return std::nullopt;
    const bool is_blocked_all_over = (is_blocked && edge > reach) || edge + reach < radius + required;
    if (is_blocked_all_over) {
      const Contact contact = world.clearance(disc, make_pose(p, 0.0), required + 1.0);
      is_outside = is_outside && contact.outside;
      std::string name = world.source_name(contact.source);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
      continue;
    }
    const Vec2 quarter = 0.5 * part.half;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) parts.push_back({p + Vec2{x * quarter.x, y * quarter.y}, quarter});
    }
  }
  Failure failure;
  failure.pose = make_pose(0.5 * (box.low + box.high), 0.0);
  failure.status = is_outside ? Status::goal_outside : Status::goal_in_collision;
  failure.reason = is_outside ? fmt::format("the goal's region lies outside of {}", words_of(names))
                              : fmt::format("no place in the goal's region is free: {} block{} all of it{}{}", words_of(names), names.size() == 1 ? "s" : "",
                                            radius > 0.0 ? fmt::format(", even for the largest disc in the footprint, {:.3f} m", radius) : "",
                                            required > 0.0 ? fmt::format(", with the {:.4f} m that are required (clearance and pose error)", required) : "");
  return failure;
}

}  // namespace waywright
