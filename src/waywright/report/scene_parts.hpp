// Pieces of the picture: what the map shows, what is drawn on it, what is written beside it.
#pragma once

#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/report/labels.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

inline constexpr double left_gutter = 40.0;    ///< px, of the coordinates beside the map
inline constexpr double bottom_gutter = 20.0;  ///< px, of those below it

/// Where the map lies in the picture.
struct Canvas {
  View view;
  Box region;
  double width = 0.0, height = 0.0;  ///< px, gutters included
};

/// What must be seen, scaled to about `width` pixels; a map (of lines, where it has no boundary) or the lanes on it that are not much larger are shown whole.
Canvas canvas_for(const Map& map, const std::vector<Vec2>& seen, double width, const std::vector<Polyline>& lanes = {});
/// The same of start, goal, station and paths.
Canvas canvas_for(const Problem& problem, const std::vector<const Plan*>& plans, double width);
/// Of what is driven alone, with a margin: start, goal, path, shelf, and where it is blocked; no smaller than what fills some 200 px squared, and wide where it is.
Canvas small_canvas(const Problem& problem, const Plan& plan);
Canvas small_canvas(const std::vector<Vec2>& seen);

/// The footprint's outline in the world; a disc as 36 corners.
Ring outline_at(const Footprint& footprint, const Pose& pose);

void open_map(SvgWriter& svg, const Canvas& canvas);
/// Map and station.
void draw_map(SvgWriter& svg, const Scenario& scenario, const Box& region);
/// Obstacles and lines, off which texts keep, get the numbers by which sentences name them, those within the region and not too many; the one that `tightest` names ("obstacle 4") first. Returns
/// whether there are any.
bool name_obstacles(Labels& labels, const View& view, const Map& map, const Box& region, const std::string& tightest = {});
void draw_station(SvgWriter& svg, const Station& station);
/// The map alone; of it the cells alone.
void draw_map(SvgWriter& svg, const Map& map, const Box& region);
void draw_map_cells(SvgWriter& svg, const Map& map, const Box& region);
/// Outline and heading.
void draw_vehicle(SvgWriter& svg, const Footprint& footprint, const Pose& pose);
/// The mission's last pose; a goal that leaves the heading free as it is, and the vehicle where the plan has it then. Returns where its name belongs.
Vec2 draw_goal(SvgWriter& svg, const Problem& problem, const Plan& plan);
/// A letter beside a place of the vehicle; texts keep off the outline.
void name_end(Labels& labels, Vec2 point, const std::string& name);
/// Runs of equal direction in its colour, with arrows.
void draw_path(SvgWriter& svg, const std::vector<Sample>& samples);
void draw_sweep(SvgWriter& svg, const Footprint& footprint, const std::vector<Sample>& samples);

void draw_waypoints(SvgWriter& svg, const Scenario& scenario, Labels& labels);

/// Of the i-th of several plans in one picture; no two have both alike.
struct OverlayStroke {
  const char* colour;
  std::string dashes;  ///< as stroke-dasharray; empty: solid
};
OverlayStroke overlay_stroke(std::size_t i);
/// The attributes of an SVG element that is drawn so.
std::string stroke_attributes(const OverlayStroke& stroke);
/// The <svg> element about a picture.
std::string framed(std::string body, double width, double height, std::string_view title);
/// The same about a small picture, without its gutters.
std::string framed_small(std::string body, const Canvas& canvas, std::string_view title);

/// Of what is written within the map.
Labels labels_for(const Canvas& canvas);
/// The tightest spot of a certificate, with its clearance: of the footprint at its pose to the obstacle's point.
void draw_tightest_spot(SvgWriter& svg, Labels& labels, const Footprint& footprint, const Certificate& certificate, bool has_pose_error, bool is_proven);
/// The footprint's point nearest to an obstacle's.
Vec2 point_on(const Footprint& footprint, const Pose& pose, Vec2 obstacle);

/// Ticks with world coordinates along the left and lower edge.
void draw_axes(SvgWriter& svg, const Canvas& canvas);
void draw_scale(SvgWriter& svg, const Canvas& canvas);

struct LegendEntry {
  const char* style;
  enum class Shape { line, box, dot, square, cross, hollow, peak, trap, none } shape;  ///< cross to trap: places of a field, which have a style of their own
  std::string text;
};
/// Such a place, about a pixel. @pre one of cross, hollow, peak, trap
std::string critical_mark(LegendEntry::Shape shape, double x, double y);
/// Lines of entries from y on; returns where they end.
double draw_legend(SvgWriter& svg, const std::vector<LegendEntry>& entries, double width, double y);
/// Of several plans in one picture: a line each with a sample of its stroke (empty: nothing of it is drawn), wrapped where it is too long, in columns where there
/// are many; above them what all share, if anything. Returns where they end.
struct OverlayEntry {
  std::string stroke, text;
};
double draw_overlay_legend(SvgWriter& svg, const std::vector<OverlayEntry>& entries, const std::string& shared, double width, double y);
/// The same as a list beside the picture, whose text keeps its size where the picture shrinks.
std::string legend_html(const std::vector<LegendEntry>& entries);

}  // namespace waywright
