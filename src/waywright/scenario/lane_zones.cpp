#include "waywright/scenario/lane_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "waywright/geometry/boolean.hpp"

namespace waywright {
namespace {

constexpr double most_leaving = 75.0 * std::numbers::pi / 180.0;  // of a bend from its zone's direction, where 90° are allowed
constexpr double least_stretch = 0.05;                            // m: shorter ones get no zone
constexpr std::size_t most_told = 8;
constexpr double least_share = 0.01;                              // of a square of the width: smaller rests of strips get no zone

/// What is left of a course where so much is cut off at both ends.
Polyline trimmed(const Polyline& course, double from_start, double from_end) {
  double whole = 0.0;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) whole += distance(course[i], course[i + 1]);
  const double low = from_start, high = whole - from_end;
  Polyline left;
  double s = 0.0;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const double piece = distance(course[i], course[i + 1]);
    if (!(piece > 0.0)) continue;
    const double a = std::max(low, s), b = std::min(high, s + piece);
    if (b - a > 0.0) {
      const auto at = [&](double where) { return course[i] + ((where - s) / piece) * (course[i + 1] - course[i]); };
      if (left.empty()) left.push_back(at(a));
      left.push_back(at(b));
    }
    s += piece;
  }
  return left;
}

Ring strip(Vec2 a, Vec2 b, double half) {
  const Vec2 across = (half / distance(a, b)) * left_of(b - a);
  return {a - across, b - across, b + across, a + across};
}

/// One ring along a bend; empty where it would cross itself.
std::optional<Ring> strip_along(const Polyline& course, double half) {
  if (2 * course.size() > most_zone_corners) return std::nullopt;
  Ring right, left;
  for (std::size_t i = 0; i < course.size(); ++i) {
    const Vec2 before = i > 0 ? course[i] - course[i - 1] : course[1] - course[0], after = i + 1 < course.size() ? course[i + 1] - course[i] : before;
    const Vec2 u = (1.0 / norm(before)) * before, v = (1.0 / norm(after)) * after;
    const Vec2 both = u + v;
    if (!(squared_norm(both) > 1.0)) return std::nullopt;  // it bends by more than 60° at once
    const Vec2 across = (2.0 * half / squared_norm(both)) * left_of(both);  // where the two sides' lines meet
    right.push_back(course[i] - across);
    left.push_back(course[i] + across);
  }
  std::reverse(left.begin(), left.end());
  right.insert(right.end(), left.begin(), left.end());
  RingRepair repair = repair_ring(std::move(right));
  if (repair.refused || !repair.mended.empty()) return std::nullopt;
  return std::move(repair.ring);
}

/// The strip as one ring where that is simple, else a ring for each stretch; with the direction from its first to its last point.
struct Strip {
  Ring ring;
  double direction = 0.0;
};

std::vector<Strip> strips(const Polyline& course, double half, bool must_keep_direction) {
  if (course.size() < 2) return {};
  const Vec2 whole = course.back() - course.front();
  bool keeps = squared_norm(whole) > 0.0;
  for (std::size_t i = 0; i + 1 < course.size() && keeps; ++i) {
    const Vec2 piece = course[i + 1] - course[i];
    keeps = std::abs(arc_tangent(cross(whole, piece), dot(whole, piece))) <= most_leaving;
  }
  if (keeps || !must_keep_direction) {
    if (auto ring = course.size() == 2 ? std::optional{strip(course[0], course[1], half)} : strip_along(course, half)) return {{std::move(*ring), angle_of(whole)}};
  }
  std::vector<Strip> all;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    if (distance(course[i], course[i + 1]) >= least_stretch) all.push_back({strip(course[i], course[i + 1], half), angle_of(course[i + 1] - course[i])});
  }
  return all;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double ac = cross(b - a, c - a), ad = cross(b - a, d - a), ca = cross(d - c, a - c), cb = cross(d - c, b - c);
  return ((ac > 0.0) != (ad > 0.0)) && ((ca > 0.0) != (cb > 0.0));
}

bool overlap(const Ring& a, const Ring& b) {
  const Box of_a = bounding_box(a), of_b = bounding_box(b);
  if (of_a.high.x < of_b.low.x || of_b.high.x < of_a.low.x || of_a.high.y < of_b.low.y || of_b.high.y < of_a.low.y) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (cross_each_other(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
    }
  }
  return contains(a, b.front()) || contains(b, a.front());
}

/// What of a strip is in none of the others: zones that overlap would prefer junctions, and lanes beside each other, to the lanes.
std::vector<Ring> beyond(const Ring& strip, const std::vector<Ring>& others, double least_area) {
  std::vector<Ring> left{strip};
  for (const Ring& other : others) {
    std::vector<Ring> next;
    for (Ring& ring : left) {
      if (!overlap(ring, other)) {
        next.push_back(std::move(ring));
        continue;
      }
      auto parts = without(ring, other);
      if (!parts) parts = std::vector<Ring>{std::move(ring)};  // with a hole, say: then it overlaps
      for (Ring& part : *parts) {
        if (std::abs(signed_area(part)) > least_area) next.push_back(std::move(part));
      }
    }
    left = std::move(next);
  }
  return left;
}

class Directions {
 public:
  Directions(const LaneGraph& graph, double width) : graph_{graph}, half_{0.5 * width}, strips_(graph.lanes.size()) {}

  std::vector<std::vector<Strip>> make(std::vector<std::string>& notes) {
    std::size_t short_ones = 0;
    for (std::size_t i = 0; i < graph_.lanes.size(); ++i) {
      const Lane& lane = graph_.lanes[i];
      if (lane.is_both_ways) continue;
      const double begin = trim(i, false), end = trim(i, true);
      if (begin + end + least_stretch <= length(lane)) strips_[i] = strips(trimmed(lane.course, begin, end), half_, true);
      if (strips_[i].empty()) ++short_ones;
    }
    if (short_ones > 0) notes.push_back(fmt::format("{} one-way lane{} too short beside junctions for a directed zone of this width", short_ones, short_ones == 1 ? " is" : "s are"));
    drop_contradictions(notes);
    return std::move(strips_);
  }

 private:
  /// How much a lane's zone leaves off at an end: half a width, and more where a lane that meets it there leads the other way beside it.
  double trim(std::size_t index, bool at_end) const {
    const Lane& lane = graph_.lanes[index];
    const std::size_t place = at_end ? lane.to : lane.from;
    const double away = at_end ? wrap(last_heading(lane) + std::numbers::pi) : first_heading(lane);
    double most = half_;
    for (std::size_t i = 0; i < graph_.lanes.size(); ++i) {
      const Lane& other = graph_.lanes[i];
      if (i == index || other.is_both_ways) continue;
      // Of the two lanes at a place one that arrives and one that leaves have opposite directions where they lie beside each other.
      for (const bool other_at_end : {false, true}) {
        if ((other_at_end ? other.to : other.from) != place || other_at_end == at_end) continue;
        const double theirs = other_at_end ? wrap(last_heading(other) + std::numbers::pi) : first_heading(other);
        const double between = std::abs(wrap(theirs - away));
        if (between >= 0.5 * std::numbers::pi || between <= 1e-6) continue;
        const SinCos turn = sin_cos(between);
        most = std::max(most, half_ * (1.0 + turn.cos) / turn.sin + 0.01);  // the strips part at half the width over the tangent of half the angle
      }
    }
    return most;
  }

  void drop_contradictions(std::vector<std::string>& notes) {
    std::vector<bool> is_dropped(strips_.size(), false);
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      for (std::size_t j = i + 1; j < strips_.size(); ++j) {
        const bool contradict = std::any_of(strips_[i].begin(), strips_[i].end(), [&](const Strip& a) {
          return std::any_of(strips_[j].begin(), strips_[j].end(), [&](const Strip& b) {
            return std::abs(wrap(a.direction - b.direction)) > 0.5 * std::numbers::pi && overlap(a.ring, b.ring);
          });
        });
        if (contradict) is_dropped[i] = is_dropped[j] = true;
      }
    }
    std::string named;
    std::size_t count = 0;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      if (!is_dropped[i]) continue;
      strips_[i].clear();
      if (++count <= most_told) named += (named.empty() ? "" : ", ") + graph_.lanes[i].name;
    }
    if (count > most_told) named += fmt::format(" and {} more", count - most_told);
    if (count > 0) notes.push_back(fmt::format("{} one-way lanes have no direction, as they lie nearer than their width to one that leads the other way: {}", count, named));
  }

  const LaneGraph& graph_;
  double half_;
  std::vector<std::vector<Strip>> strips_;
};

}  // namespace

Parsed<LaneZones> lane_zones(const LaneGraph& graph, const LaneRules& rules) {
  LaneZones made;
  const double half = 0.5 * rules.width;
  if (rules.is_directed) {
    const std::vector<std::vector<Strip>> directed = Directions{graph, rules.width}.make(made.notes);
    for (std::size_t i = 0; i < directed.size(); ++i) {
      for (const Strip& one : directed[i]) made.zones.push_back({.type = ZoneType::directed, .name = graph.lanes[i].name, .area = one.ring, .direction = one.direction});
    }
  }
  std::vector<Ring> preferred;
  const double least_area = least_share * rules.width * rules.width;
  for (const Lane& lane : graph.lanes) {
    const bool is_slow = lane.speed && *lane.speed < rules.vehicle_speed;
    if (!is_slow && !rules.preference) continue;
    for (Strip& one : strips(trimmed(lane.course, 0.0, 0.0), half, false)) {
      if (rules.preference) {
        for (Ring& part : beyond(one.ring, preferred, least_area)) made.zones.push_back({.type = ZoneType::preferred, .name = lane.name, .area = std::move(part), .factor = *rules.preference});
        preferred.push_back(one.ring);
      }
      if (is_slow) made.zones.push_back({.type = ZoneType::speed_limit, .name = lane.name, .area = std::move(one.ring), .speed = std::max(least_zone_speed, *lane.speed)});
    }
  }
  if (made.zones.size() > most_zones) {
    return tl::unexpected{InputError{"", "zones", fmt::format("its lanes would be {} zones", made.zones.size()), fmt::format("at most {}", most_zones)}};
  }
  return made;
}

}  // namespace waywright
