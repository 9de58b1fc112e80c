#include "waywright/report/mission_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "waywright/io/lane_courses.hpp"
#include "waywright/report/scene_lanes.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/report/scene_zones.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

constexpr double load_step = 1.2;            // m between the drawn places of a load
constexpr std::size_t most_in_legend = 24;   // legs

/// None near to blue and orange, which stand for forwards and backwards, nor to the pink of shelves.
const char* leg_colour(std::size_t i) {
  static constexpr std::array palette{"#007a4d", "#6a3d9a", "#b89b00", "#5c6670", "#a1006b", "#7a9a01", "#8a5a2b", "#00a3a3"};
  return palette[i % palette.size()];
}

class MissionScene {
 public:
  /// Without a width: small.
  MissionScene(const Plan& plan, const std::vector<LegView>& legs, std::optional<double> width)
      : plan_{plan}, legs_{legs}, canvas_{width ? canvas_for(plan.scenario.map, seen(), *width, lane_courses_of(plan.scenario.meta).courses) : small_canvas(seen())}, svg_{canvas_.view}, labels_{labels_for(canvas_)} {}

  void draw(bool is_small) {
    const Scenario& mission = plan_.scenario;
    open_map(svg_, canvas_);
    draw_zone_areas(svg_, mission.zones);
    draw_map(svg_, mission.map, canvas_.region);
    if (!is_small) {
      lanes_ = draw_lane_courses(svg_, mission.meta, mission.zones);
      numbered_ = name_obstacles(labels_, canvas_.view, mission.map, canvas_.region, plan_.tightest_obstacle);
    }
    for (const Leg& leg : mission.legs) draw_place_of(leg);
    if (!is_long()) {
      for (const LegView& leg : legs_) draw_sweep(svg_, leg.footprint, leg.samples);
      for (const LegView& leg : legs_) draw_load(leg);
    }
    for (const LegView& leg : legs_) {
      if (leg.set_down.empty()) continue;
      svg_.polygon(leg.set_down, "setdown");
      set_down_ = true;
    }
    for (std::size_t i = 0; i < legs_.size(); ++i) draw_under(i);
    for (const LegView& leg : legs_) draw_path(svg_, leg.samples);
    if (!is_small) {
      for (const LegView& leg : legs_) draw_turning_points(leg);
      for (const Leg& leg : mission.legs) draw_waypoints_of(leg);
    }
    for (const LegView& leg : legs_) {
      std::vector<Vec2> way;
      for (const Sample& sample : leg.samples) way.push_back({sample.x, sample.y});
      labels_.keep_off(way, false);
    }
    if (!is_small) name_zones(labels_, canvas_.view, mission.zones, canvas_.region);
    draw_ends();
    for (std::size_t i = 0; i < legs_.size(); ++i) draw_number(i);
    draw_spots(is_small);
    crowded_ = labels_.write(svg_) > 0 || crowded_;
    svg_.close_group();
    if (is_small) return;
    draw_axes(svg_, canvas_);
    draw_scale(svg_, canvas_);
  }

  std::vector<LegendEntry> legend() const {
    using Shape = LegendEntry::Shape;
    std::vector<LegendEntry> entries{{"", Shape::none, "S start, E1, E2 …: where a leg ends"}};
    const auto has = [&](auto&& is_so) {
      return std::any_of(legs_.begin(), legs_.end(), [&](const LegView& leg) { return std::any_of(leg.samples.begin(), leg.samples.end(), is_so); });
    };
    const bool slides = has([](const Sample& s) { return !s.faces_along; });
    if (has([](const Sample& s) { return s.direction > 0; })) entries.push_back({"fwd", Shape::line, slides ? "path, not facing along it" : "forwards"});
    if (has([](const Sample& s) { return s.direction < 0; })) entries.push_back({"back", Shape::line, "backwards"});
    if (is_long()) entries.push_back({"", Shape::none, "so long a way is drawn without what is swept"});
    else entries.push_back({"sweep", Shape::box, "swept by the footprint"});
    if (loads_) entries.push_back({"load", Shape::box, "load, where it is carried"});
    if (set_down_) entries.push_back({"setdown", Shape::box, "load, where it is set down: an obstacle to later legs"});
    if (turns_) entries.push_back({"stop", Shape::square, "change between forwards and backwards"});
    if (waypoints_) entries.push_back({"waypoint", Shape::dot, "waypoints of a leg, in order"});
    if (stations_) {
      entries.push_back({"shelf", Shape::box, "shelf, loading face bold"});
      entries.push_back({"area", Shape::line, "station"});
    }
    if (regions_) entries.push_back({"region", Shape::box, "region in which a leg ends"});
    if (lanes_) entries.push_back(lane_legend().front());
    for (LegendEntry& entry : zone_legend(plan_.scenario.zones)) entries.push_back(std::move(entry));
    if (blocked_) entries.push_back({"hit", Shape::box, "where it touches or comes too near"});
    if (tight_) entries.push_back({"tightdot", Shape::dot, "tightest spot of all"});
    if (spots_) entries.push_back({"spot", Shape::dot, "tightest spot of a leg"});
    if (numbered_) entries.push_back({"", Shape::none, "0, 1, 2 … on obstacles: as the text names them"});
    if (crowded_) entries.push_back({"", Shape::none, "numbers and names are left out where they have no room"});
    return entries;
  }

  /// Lines of the legs' colours and names from y on; returns where they end.
  double draw_legs(double y) {
    for (std::size_t i = 0; i < plan_.legs.size() && i < most_in_legend; ++i) {
      svg_.raw(fmt::format("{}<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", badge(i, left_gutter + 11.0, y - 4.0), fixed(left_gutter + 28.0), fixed(y), escaped(words_of(i))));
      y += 20.0;
    }
    return y;
  }
  std::string legs_html() const {
    std::string out = "<ul class=\"legend\">\n";
    for (std::size_t i = 0; i < plan_.legs.size() && i < most_in_legend; ++i)
      out += fmt::format("<li><svg class=\"ww\" width=\"22\" height=\"20\">{}</svg>{}</li>\n", badge(i, 11.0, 10.0), escaped(words_of(i)));
    return out + "</ul>\n";
  }

  const Canvas& canvas() const { return canvas_; }
  SvgWriter& svg() { return svg_; }

 private:
  /// Footprints along kilometres make pictures that nobody can open.
  bool is_long() const {
    constexpr std::size_t most_samples_swept = 40'000;
    std::size_t samples = 0;
    for (const LegView& leg : legs_) samples += leg.samples.size();
    return samples > most_samples_swept;
  }

  std::vector<Vec2> seen() const {
    std::vector<Vec2> points;
    const auto add = [&](const Ring& ring) { points.insert(points.end(), ring.begin(), ring.end()); };
    add(outline_at(plan_.scenario.vehicle.footprint, plan_.scenario.start));
    for (const Leg& leg : plan_.scenario.legs) {
      if (const auto* station = std::get_if<Station>(&leg.mission)) {
        add(station->area);
        add(station->shelf.outline());
      }
    }
    for (const LegView& leg : legs_) {
      add(outline_at(leg.footprint, leg.first));
      add(outline_at(leg.footprint, leg.last));
      for (std::size_t i = 0; i < leg.samples.size(); i += 10) add(outline_at(leg.footprint, leg.samples[i].pose()));
    }
    return points;
  }

  std::string words_of(std::size_t i) const {
    const LegResult& leg = plan_.legs[i];
    return fmt::format("{}{}{}", leg.name.empty() ? fmt::format("leg {}", i + 1) : leg.name, leg.load.empty() ? "" : fmt::format(", with {}", leg.load),
                       leg.status == Status::solved ? "" : fmt::format(" ({})", to_string(leg.status)));
  }

  static std::string badge(std::size_t i, double x, double y) {
    const std::string number = fmt::format("{}", i + 1);
    return fmt::format("<circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" class=\"badge\" style=\"stroke:{3}\"/><text class=\"badgetext\" x=\"{0}\" y=\"{4}\">{5}</text>", fixed(x), fixed(y),
                       fixed(number.size() > 2 ? 12.0 : 9.0), leg_colour(i), fixed(y + 4.0), number);
  }

  void draw_place_of(const Leg& leg) {
    if (const auto* station = std::get_if<Station>(&leg.mission)) {
      draw_station(svg_, *station);
      stations_ = true;
    } else if (const auto* free = std::get_if<FreeGoal>(&leg.mission); free != nullptr && !free->is_point()) {
      svg_.polygon(free->area, "region");
      regions_ = true;
    }
  }

  /// The leg's colour below its path.
  void draw_under(std::size_t i) {
    std::vector<Vec2> points;
    for (const Sample& s : legs_[i].samples) points.push_back({s.x, s.y});
    if (points.size() > 1) svg_.stroked_polyline(points, fmt::format("stroke=\"{}\" style=\"stroke-width:11px;stroke-opacity:.38;stroke-linecap:round\"", leg_colour(i)));
  }

  void draw_load(const LegView& leg) {
    if (leg.load == nullptr || leg.samples.empty()) return;
    loads_ = true;
    double next = 0.0;
    for (std::size_t i = 0; i < leg.samples.size(); ++i) {
      if (leg.samples[i].s < next && i + 1 < leg.samples.size()) continue;
      next = leg.samples[i].s + load_step;
      svg_.polygon(outline_at(*leg.load, leg.samples[i].pose()), "load");
    }
  }

  void draw_turning_points(const LegView& leg) {
    int driving = 0;
    for (const Sample& s : leg.samples) {
      if (s.direction == 0) continue;
      if (driving != 0 && s.direction != driving) {
        svg_.polygon(outline_at(leg.footprint, s.pose()), "ghost");
        svg_.square(s.pose().position(), 8.0, "stop");
        turns_ = true;
      }
      driving = s.direction;
    }
  }

  void draw_waypoints_of(const Leg& leg) {
    if (leg.waypoints.empty()) return;
    Scenario one;
    one.waypoints = leg.waypoints;
    one.waypoint_radius = leg.waypoint_radius;
    draw_waypoints(svg_, one, labels_);
    waypoints_ = true;
  }

  /// Where legs begin and end; a place that several of them share has one outline and all their names.
  void draw_ends() {
    struct End {
      Pose pose;
      const Footprint* footprint;
      std::string name;
    };
    std::vector<End> ends;
    const auto add = [&](const Pose& pose, const Footprint& footprint, const std::string& name) {
      const auto there = std::find_if(ends.begin(), ends.end(), [&](const End& end) { return distance(end.pose.position(), pose.position()) < 0.05; });
      if (there == ends.end()) ends.push_back({pose, &footprint, name});
      else there->name += ", " + name;
    };
    if (legs_.empty()) return;
    add(legs_.front().first, legs_.front().footprint, "S");
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      if (!legs_[i].samples.empty() || plan_.samples.empty()) add(legs_[i].last, legs_[i].footprint, fmt::format("E{}", i + 1));
    }
    for (const End& end : ends) {
      draw_vehicle(svg_, *end.footprint, end.pose);
      labels_.keep_off(outline_at(*end.footprint, end.pose), true);
      name_end(labels_, end.pose.position(), end.name);
    }
  }

  /// In the middle of the leg, or where fewer of the numbers before it are near; nowhere where all of the leg is full of them.
  void draw_number(std::size_t i) {
    const std::vector<Sample>& samples = legs_[i].samples;
    if (samples.size() < 2) return;
    constexpr double enough = 30.0;   // px between two
    constexpr double least = 19.0;    // px, a badge's width and a little
    constexpr double half = 10.0;     // px, of a badge
    Vec2 best{};
    double farthest = -1.0;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.42, 0.58, 0.27, 0.73, 0.12, 0.88, 0.05, 0.95}) {
      const auto there = std::find_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.s >= share * samples.back().s; });
      const Vec2 at = canvas_.view(there->pose().position());
      double nearest = enough;
      for (const Vec2 other : numbers_) nearest = std::min(nearest, distance(at, other));
      if (nearest <= farthest) continue;
      farthest = nearest;
      best = at;
    }
    if (farthest < (i >= 99 ? least + 6.0 : least)) {
      crowded_ = true;
      return;
    }
    numbers_.push_back(best);
    const Vec2 reach{i >= 99 ? half + 3.0 : half, i >= 99 ? half + 3.0 : half};
    labels_.room().take(Box{best - reach, best + reach});
    svg_.raw(badge(i, best.x, best.y) + "\n");
  }

  void draw_spots(bool is_small) {
    for (const LegView& leg : legs_) {
      for (const Spot& spot : leg.blocked) {
        blocked_ = true;
        svg_.polygon(outline_at(leg.footprint, spot.pose), "hit");
        svg_.dot(spot.point, 4.5, "tightdot");
      }
    }
    const Certificate& all = plan_.certificate;
    if (plan_.samples.empty() || !all.tightest || is_beyond_measure(all)) return;
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const Certificate& c = plan_.legs[i].certificate;
      if (!c.tightest || is_beyond_measure(c)) continue;
      if (*c.tightest == *all.tightest && c.tightest_point == all.tightest_point && !tight_) {
        tight_ = true;
        if (is_small) svg_.dot(c.tightest_point, 4.0, "tightdot");
        else draw_tightest_spot(svg_, labels_, legs_[i].footprint, all, legs_[i].margin > 0.0, plan_.status == Status::solved);
      } else if (!is_small) {
        svg_.dot(c.tightest_point, 3.5, "spot");
        spots_ = true;
      }
    }
  }

  const Plan& plan_;
  const std::vector<LegView>& legs_;
  Canvas canvas_;
  SvgWriter svg_;
  Labels labels_;
  std::vector<Vec2> numbers_;  ///< px, where the legs' numbers stand
  bool lanes_ = false, crowded_ = false, numbered_ = false, stations_ = false, regions_ = false, loads_ = false, set_down_ = false, turns_ = false, waypoints_ = false, blocked_ = false, tight_ = false, spots_ = false;
};

}  // namespace

std::string mission_scene_svg(const Plan& plan, const std::vector<LegView>& legs, double width) {
  MissionScene scene{plan, legs, width};
  scene.draw(false);
  const double whole = std::max(scene.canvas().width, 480.0);
  const double end = draw_legend(scene.svg(), scene.legend(), whole, scene.canvas().height + 40.0);
  const double last = scene.draw_legs(end + 24.0);
  return framed(scene.svg().take(), whole, last, plan.scenario.name);
}

std::string mission_scene_html(const Plan& plan, const std::vector<LegView>& legs, double width) {
  MissionScene scene{plan, legs, width};
  scene.draw(false);
  const std::string picture = framed(scene.svg().take(), std::max(scene.canvas().width, 320.0), scene.canvas().height + 26.0, plan.scenario.name);
  return "<div class=\"scene\">\n" + picture + scene.legs_html() + legend_html(scene.legend()) + "</div>\n";
}

SmallPicture mission_small_picture(const Plan& plan, const std::vector<LegView>& legs) {
  MissionScene scene{plan, legs, std::nullopt};
  scene.draw(true);
  return {framed_small(scene.svg().take(), scene.canvas(), plan.scenario.name), std::round(scene.canvas().width - left_gutter), std::round(scene.canvas().height - bottom_gutter)};
}

}  // namespace waywright
