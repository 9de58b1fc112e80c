#include "waywright/report/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/geometry/polygon.hpp"
#include "waywright/report/scene_field.hpp"
#include "waywright/report/scene_lanes.hpp"
#include "waywright/report/scene_moving.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/report/scene_search.hpp"
#include "waywright/report/scene_zones.hpp"
#include "waywright/report/spots.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

/// The point of a curve that is farthest from everything else that is drawn, for its name.
Vec2 calm_point(const std::vector<Vec2>& curve, const std::vector<Vec2>& busy) {
  Vec2 best = curve[curve.size() / 2];
  double most = -1.0;
  for (const Vec2 p : curve) {
    double nearest = 1e9;
    for (const Vec2 b : busy) nearest = std::min(nearest, distance(p, b));
    if (nearest > most) {
      most = nearest;
      best = p;
    }
  }
  return best;
}

/// Are there cells in sight of which nothing is known?
bool shows_unknown(const Map& map, const Box& region) {
  constexpr std::uint8_t unknown = 2;
  for (const CellGrid& grid : map.grids) {
    const auto found = std::find_if(grid.blocked.begin(), grid.blocked.end(), [&, i = std::int64_t{-1}](std::uint8_t cell) mutable {
      ++i;
      return cell == unknown && region.contains(grid.corner(static_cast<double>(i % grid.columns) + 0.5, static_cast<double>(i / grid.columns) + 0.5));
    });
    if (found != grid.blocked.end()) return true;
  }
  return false;
}

class Scene {
 public:
  Scene(const Problem& problem, const Plan& plan, const Canvas& canvas) : problem_{problem}, plan_{plan}, canvas_{canvas}, svg_{canvas_.view}, labels_{labels_for(canvas_)} {}

  void draw() {
    if (plan_.field) field_ = plan_.field->of(problem_, canvas_.region);
    open_map(svg_, canvas_);
    if (field_) draw_field(svg_, *field_);
    draw_zone_areas(svg_, problem_.scenario().zones);
    draw_zones();
    draw_map(svg_, problem_.scenario(), canvas_.region);
    lanes_ = draw_lane_courses(svg_, problem_.scenario().meta, problem_.scenario().zones);
    numbered_ = name_obstacles(labels_, canvas_.view, problem_.scenario().map, canvas_.region, plan_.tightest_obstacle);
    if (plan_.replanned) draw_replanned(svg_, *plan_.replanned);
    if (plan_.search) draw_search(svg_, *plan_.search, canvas_.region);
    take_room();
    if (field_) svg_.open_group("onfield");
    draw_sweep(svg_, problem_.footprint(), plan_.samples);
    draw_alternatives();
    if (field_) draw_casing();
    draw_path(svg_, plan_.samples);
    if (field_) svg_.close_group();
    meets_ = draw_moving(svg_, labels_, problem_, plan_, canvas_.region);
    name_zones(labels_, canvas_.view, problem_.scenario().zones, canvas_.region);
    draw_stops();
    if (field_) draw_field_marks(svg_, *field_);
    draw_waits(svg_, labels_, plan_);
    draw_waypoints(svg_, problem_.scenario(), labels_);
    draw_ends();
    draw_blocked();
    draw_tightest();
    crowded_ = labels_.write(svg_) > 0 || crowded_;
    svg_.close_group();
    draw_axes(svg_, canvas_);
    draw_scale(svg_, canvas_);
  }

  /// Without what only a large picture can show.
  void draw_small() {
    open_map(svg_, canvas_);
    draw_zone_areas(svg_, problem_.scenario().zones);
    draw_map(svg_, problem_.scenario(), canvas_.region);
    draw_sweep(svg_, problem_.footprint(), plan_.samples);
    draw_path(svg_, plan_.samples);
    draw_ends();
    draw_blocked();
    const Certificate& c = plan_.certificate;
    if (!plan_.samples.empty() && c.tightest && !is_beyond_measure(c)) svg_.dot(c.tightest_point, 4.0, "tightdot");
    labels_.write(svg_);
    svg_.close_group();
  }

  std::vector<LegendEntry> legend() const {
    using Shape = LegendEntry::Shape;
    std::vector<LegendEntry> entries;
    const auto& footprint = problem_.footprint();
    const bool forks = std::holds_alternative<Station>(problem_.scenario().mission) && !footprint.is_disc();
    const char* end = problem_.is_driven_back()                                      ? ", E end"
                      : std::holds_alternative<Station>(problem_.scenario().mission) ? ", D docked"
                                                                                     : ", G goal";
    entries.push_back(
        {"", Shape::none, fmt::format("S start{}{}", !turns_ ? "" : !changes_ ? ", T turn on the spot" : spins_ ? ", T change of direction or turn on the spot" : ", T change of direction", end)});
    if (!plan_.samples.empty()) {
      const auto drives = [&](int direction) {
        return std::any_of(plan_.samples.begin(), plan_.samples.end(),
                           [&](const Sample& s) { return s.direction == direction; });
      };
      if (drives(-1))
        entries.push_back({"back", Shape::line, forks ? "backwards (chassis first)" : "backwards"});
      const bool slides = std::any_of(plan_.samples.begin(), plan_.samples.end(), [](const Sample& s) { return !s.faces_along; });
      if (drives(1)) entries.push_back({"fwd", Shape::line, slides ? "path, not facing along it" : forks ? "forwards (forks first)" : "forwards"});
      entries.push_back({"sweep", Shape::box, "swept by the footprint"});
    }
    if (!problem_.scenario().waypoints.empty()) entries.push_back({"waypoint", Shape::dot, "1, 2, 3 …: waypoints in order"});
    if (stops_) entries.push_back({"stop", Shape::square, "stop where the curvature jumps"});
    if (crowded_) entries.push_back({"", Shape::none, "marks and names are left out where they have no room"});
    for (LegendEntry& entry : moving_legend(plan_, meets_)) entries.push_back(std::move(entry));
    if (const auto* station = std::get_if<Station>(&problem_.scenario().mission)) {
      entries.push_back({"shelf", Shape::box, "shelf, loading face bold"});
      if (station->insertion) entries.push_back({"pocket", Shape::box, "pocket"});
      entries.push_back({"area", Shape::line, "station"});
    }
    if (lanes_) entries.push_back(lane_legend().front());
    for (LegendEntry& entry : zone_legend(problem_.scenario().zones)) entries.push_back(std::move(entry));
    if (const FreeGoal* free = problem_.free_goal(); free != nullptr && !free->is_point()) entries.push_back({"region", Shape::box, "region of the goal"});
    if (zones_) entries.push_back({"zone", Shape::box, "where the change of direction was searched"});
    if (others_)
      entries.push_back(
          {"alt", Shape::line,
           plan_.samples.empty() ? "tried in vain, as far as it came" : "what was not taken"});
    if (plan_.search) {
      for (LegendEntry& entry : search_legend(*plan_.search, canvas_.region)) entries.push_back(std::move(entry));
    }
    if (field_) {
      for (LegendEntry& entry : field_legend(*field_, canvas_.view)) entries.push_back(std::move(entry));
    }
    if (blocked_) entries.push_back({"hit", Shape::box, "where it touches or comes too near"});
    if (tight_)
      entries.push_back(
          {"tightdot", Shape::dot, plan_.certificate.collision_free ? "tightest spot" : "contact"});
    if (off_straight_)
      entries.push_back({"spot", Shape::dot,
                         problem_.is_driven_back() ? "tightest after the first straight"
                                                   : "tightest before the final straight"});
    if (shows_unknown(problem_.scenario().map, canvas_.region)) entries.push_back({"unknown", Shape::box, "unknown, taken as occupied"});
    if (numbered_) entries.push_back({"", Shape::none, "0, 1, 2 …: obstacles as the text names them"});
    return entries;
  }

  const Canvas& canvas() const { return canvas_; }
  SvgWriter& svg() { return svg_; }

 private:
  const char* end_name() const {
    return problem_.is_driven_back()                                      ? "E"
           : std::holds_alternative<Station>(problem_.scenario().mission) ? "D"
                                                                          : "G";
  }

  void draw_ends() {
    draw_vehicle(svg_, problem_.footprint(), problem_.first_pose());
    name_end(labels_, problem_.first_pose().position(), "S");
    name_end(labels_, draw_goal(svg_, problem_, plan_), end_name());
  }

  /// Zones mean something beside a shelf; about a free goal they are half planes that cover the whole map.
  void draw_zones() {
    if (!std::holds_alternative<Station>(problem_.scenario().mission)) return;
    for (const Alternative& a : plan_.alternatives) {
      if (a.zone.size() < 3) continue;
      svg_.polygon(a.zone, "zone");
      zones_ = true;
    }
  }

  /// Path, vehicle at its ends and where it turns, and what moves: names keep off them.
  void take_room() {
    std::vector<Vec2> way;
    for (const Sample& s : plan_.samples) way.push_back({s.x, s.y});
    labels_.keep_off(way, false);
    for (const Pose& pose : {problem_.first_pose(), problem_.last_pose()}) labels_.keep_off(outline_at(problem_.footprint(), pose), true);
    for (std::size_t i = 1; i < plan_.samples.size(); ++i) {
      if (is_direction_change(plan_.samples[i - 1], plan_.samples[i])) labels_.keep_off(outline_at(problem_.footprint(), plan_.samples[i].pose()), true);
    }
    if (field_) {
      for (const FieldPicture::Critical& c : field_->critical) {
        const Vec2 at = canvas_.view(c.at), half{7.0, 7.0};
        labels_.room().take(Box{at - half, at + half});
      }
    }
    const double end = plan_.samples.empty() ? 0.0 : plan_.samples.back().t;
    for (const MovingObstacle& obstacle : plan_.scenario.moving) {
      std::vector<double> times{0.0, end};
      for (const Wait& wait : plan_.waits) times.push_back(wait.from);
      for (const double t : times) labels_.keep_off(outline_at(obstacle.footprint, obstacle.at(t)), true);
    }
  }

  /// So that the path stands out from what lies under it.
  void draw_casing() {
    std::vector<Vec2> points;
    for (const Sample& s : plan_.samples) points.push_back({s.x, s.y});
    if (points.size() > 1) svg_.polyline(points, "casing");
  }

  /// What names should keep away from.
  std::vector<Vec2> busy_points() const {
    std::vector<Vec2> busy;
    for (const Pose& pose : {problem_.first_pose(), problem_.last_pose()}) {
      const Ring ring = outline_at(problem_.footprint(), pose);
      busy.insert(busy.end(), ring.begin(), ring.end());
      busy.push_back(pose.position());
    }
    for (std::size_t i = 0; i < plan_.samples.size(); i += 8)
      busy.push_back(plan_.samples[i].pose().position());
    if (plan_.certificate.tightest) busy.push_back(plan_.certificate.tightest_point);
    return busy;
  }

  void draw_alternatives() {
    std::vector<Vec2> busy = busy_points();
    for (const Alternative& a : plan_.alternatives) {
      if (a.chosen || a.poses.size() < 2) continue;
      others_ = true;
      std::vector<Vec2> points;
      for (const Pose& p : a.poses) points.push_back(p.position());
      svg_.polyline(points, "alt");
      const std::string text = a.was_driven ? a.name
                               : !a.cost    ? a.name + ": no way"
                               : a.is_length ? fmt::format("{}: {:.2f} m", a.name, *a.cost)
                                            : fmt::format("{}: cost {:.3f}", a.name, *a.cost);
      const Vec2 at = calm_point(points, busy);
      labels_.add({{text, "note"}, LabelRank::other, {}, 0.0, at, {1.0, 0.0}});
      busy.push_back(at);
    }
  }

  void draw_stops() {
    // Where many are near each other (along a Voronoi diagram of cells, say), they would hide each other and the path.
    constexpr double room = 18.0, least = 8.0;  // px between letters, between marks
    constexpr double nearest = 20.0;            // px that a letter may stand farther off
    constexpr double same = 0.01;               // px: a turn on the spot has a mark at its begin and at its end
    const double spin_room = std::max(least, 0.6 * problem_.footprint().radius() * canvas_.view.scale);  // outlines one upon another tell nothing
    std::vector<Vec2> letters{canvas_.view(problem_.first_pose().position()), canvas_.view(problem_.last_pose().position())}, outlines, squares;
    const auto has_room = [&](std::vector<Vec2>& taken, Vec2 at, double apart, double up_to = 0.0) {
      const Vec2 p = canvas_.view(at);
      if (std::any_of(taken.begin(), taken.end(), [&](Vec2 other) { return distance(p, other) < up_to; })) return true;
      if (std::any_of(taken.begin(), taken.end(), [&](Vec2 other) { return distance(p, other) < apart; })) return false;
      taken.push_back(p);
      return true;
    };
    for (std::size_t i = 1; i < plan_.samples.size(); ++i) {
      if (!is_direction_change(plan_.samples[i - 1], plan_.samples[i])) continue;
      const Pose pose = plan_.samples[i].pose();
      const bool is_spin = plan_.samples[i - 1].direction == 0 || plan_.samples[i].direction == 0;
      // Changes of direction are all there: each is a place that somebody looks for.
      if (!is_spin || has_room(outlines, pose.position(), spin_room, same)) {
        if (is_spin) svg_.open_group("spinmark");
        draw_vehicle(svg_, problem_.footprint(), pose);
        if (!is_spin || has_room(letters, pose.position(), room)) labels_.add({{"T", "name"}, LabelRank::turn, {}, 0.0, pose.position(), {1.0, -1.0}, 7.0, nearest});
        if (is_spin) svg_.close_group();
      } else {
        crowded_ = true;
      }
      turns_ = true;
      (plan_.samples[i - 1].direction == 0 || plan_.samples[i].direction == 0 ? spins_ : changes_) = true;
    }
    for (const std::size_t i : steering_stops(plan_)) {
      const Vec2 at = plan_.samples[i].pose().position();
      if (has_room(squares, at, least)) svg_.square(at, 8.0, "stop");
      else crowded_ = true;
      stops_ = true;
    }
  }

  void draw_blocked() {
    for (const Spot& spot : blocked_spots(problem_, plan_)) {
      blocked_ = true;
      svg_.polygon(outline_at(problem_.footprint(), spot.pose), "hit");
      svg_.dot(spot.point, 4.5, "tightdot");
    }
  }

  void draw_tightest() {
    const Certificate& c = plan_.certificate;
    if (plan_.samples.empty() || !c.tightest || is_beyond_measure(c)) return;
    tight_ = true;
    blocked_ = !c.collision_free;
    draw_tightest_spot(svg_, labels_, problem_.footprint(), c, problem_.pose_error_margin() > 0.0, plan_.status == Status::solved);
    if (const auto spot = c.collision_free ? tightest_off_straight(problem_, plan_) : std::nullopt) {
      off_straight_ = true;
      const Vec2 near = point_on(problem_.footprint(), spot->pose, spot->point);
      svg_.line(near, spot->point, "spotline");
      svg_.dot(near, 3.5, "spot");
      labels_.add({{fmt::format("{:.0f} mm", 1000.0 * spot->clearance), "note"}, LabelRank::spot, {}, 0.0, near, {near.x - spot->point.x, spot->point.y - near.y}});
    }
  }

  const Problem& problem_;
  const Plan& plan_;
  Canvas canvas_;
  SvgWriter svg_;
  std::shared_ptr<const FieldPicture> field_{};
  Labels labels_;
  bool lanes_ = false, meets_ = false;
  bool zones_ = false, others_ = false, numbered_ = false, turns_ = false, changes_ = false, spins_ = false, stops_ = false, crowded_ = false, blocked_ = false,
       tight_ = false, off_straight_ = false;
};

}  // namespace

std::string framed(std::string body, double width, double height, std::string_view title) {
  return fmt::format(
      "<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" role=\"img\">\n"
      "<title>{2}</title>\n<style>{3}</style>\n<rect class=\"paper\" width=\"{0}\" "
      "height=\"{1}\"/>\n{4}</svg>\n",
      fixed(width), fixed(height), escaped(title), picture_styles(), body);
}

std::string scene_svg(const Problem& problem, const Plan& plan, double width) {
  Scene scene{problem, plan, canvas_for(problem, {&plan}, width)};
  scene.draw();
  const double whole = std::max(scene.canvas().width, 480.0);
  const double end = draw_legend(scene.svg(), scene.legend(), whole, scene.canvas().height + 40.0);
  return framed(scene.svg().take(), whole, end + 14.0, problem.scenario().name);
}

SmallPicture small_picture(const Problem& problem, const Plan& plan) {
  Scene scene{problem, plan, small_canvas(problem, plan)};
  scene.draw_small();
  return {framed_small(scene.svg().take(), scene.canvas(), problem.scenario().name), std::round(scene.canvas().width - left_gutter), std::round(scene.canvas().height - bottom_gutter)};
}

std::string framed_small(std::string body, const Canvas& canvas, std::string_view title) {
  const double w = std::round(canvas.width - left_gutter);
  const double h = std::round(canvas.height - bottom_gutter);
  return fmt::format(
      "<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0} 0 {1} {2}\" width=\"{1}\" height=\"{2}\" role=\"img\">\n"
      "<title>{3}</title>\n<style>{4}</style>\n<rect class=\"paper\" x=\"{0}\" width=\"{1}\" height=\"{2}\"/>\n{5}</svg>\n",
      fixed(left_gutter), fixed(w), fixed(h), escaped(title), picture_styles(), body);
}

std::string scene_html(const Problem& problem, const Plan& plan, double width) {
  Scene scene{problem, plan, canvas_for(problem, {&plan}, width)};
  scene.draw();
  return "<div class=\"scene\">\n" +
         framed(scene.svg().take(), std::max(scene.canvas().width, 320.0), scene.canvas().height + 26.0,
                problem.scenario().name) +
         legend_html(scene.legend()) + "</div>\n";
}

std::string overlay_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans, const std::string& shared, double width) {
  std::vector<const Plan*> all;
  for (const auto& [name, plan] : plans) all.push_back(plan);
  const Scenario& scenario = problem.scenario();
  const Canvas canvas = canvas_for(problem, all, width);
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  draw_zone_areas(svg, scenario.zones);
  draw_map(svg, scenario, canvas.region);
  draw_lane_courses(svg, scenario.meta, scenario.zones);
  Labels labels = labels_for(canvas);
  name_obstacles(labels, canvas.view, scenario.map, canvas.region);
  std::vector<OverlayEntry> legend;
  std::vector<std::vector<Vec2>> drawn;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const auto& [name, plan] = plans[i];
    std::vector<Vec2>& points = drawn.emplace_back();
    for (const Sample& s : plan->samples) points.push_back({s.x, s.y});
    const std::string stroke = points.empty() ? "" : stroke_attributes(overlay_stroke(i));
    std::string text = fmt::format("{} ({}", name, to_string(plan->status));
    if (!points.empty()) {
      svg.stroked_polyline(points, stroke);
      // One covers the other.
      const auto same = std::find(drawn.begin(), drawn.end() - 1, points) - drawn.begin();
      if (same + 1 < static_cast<std::ptrdiff_t>(drawn.size())) text += ", the same path as " + plans[static_cast<std::size_t>(same)].first;
    }
    legend.push_back({stroke, text + ")"});
  }
  for (const std::vector<Vec2>& points : drawn) labels.keep_off(points, false);
  name_zones(labels, canvas.view, scenario.zones, canvas.region);
  draw_waypoints(svg, scenario, labels);
  draw_vehicle(svg, problem.footprint(), problem.first_pose());
  name_end(labels, problem.first_pose().position(), "S");
  const char* end_name = problem.is_driven_back() ? "E" : std::holds_alternative<Station>(scenario.mission) ? "D" : "G";
  // Where the heading is free, each of them ends as it likes.
  for (const Plan* plan : all) {
    const Vec2 at = draw_goal(svg, problem, *plan);
    if (plan == all.front()) name_end(labels, at, end_name);
    if (problem.free_goal() == nullptr) break;
  }
  labels.write(svg);
  svg.close_group();
  draw_axes(svg, canvas);
  draw_scale(svg, canvas);
  const double whole = std::max(canvas.width, 480.0);
  const double end = draw_overlay_legend(svg, legend, shared, whole, canvas.height + 46.0);
  return framed(svg.take(), whole, end + 4.0, scenario.name);
}

}  // namespace waywright
