// place.json: what a check found at one place, beside the plan files, so that what did not change need not be planned again.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"

namespace waywright {

/// Where it is tight.
struct TightSpot {
  double clearance = 0.0;  ///< m
  Vec2 point{};            ///< of the obstacle
  std::string against;     ///< its name
};

/// One line of a check's table.
struct PlaceFigures {
  std::string name;
  Status status = Status::no_path;
  std::string reason;        ///< empty where solved
  bool reproducible = true;  ///< no clock cut the work short
  std::string planner;
  double asked = 0.0;        ///< m, the clearance asked for
  bool has_path = false;     ///< the figures below mean something
  bool collision_free = false;
  std::optional<TightSpot> tightest;  ///< proven, with the pose error; absent where nothing is within 10 m or nothing could be proven
  std::optional<double> pocket_clearance;  ///< m, proven, between forks and shelf beside the pockets; absent without insertion
  std::optional<TightSpot> on_the_way;  ///< tightest off the straight stretch at the shelf, at samples; absent where that stretch is not the tightest
  double length = 0.0;            ///< m
  double max_curvature = 0.0;     ///< 1/m
  std::optional<double> curvature_limit;  ///< 1/m
  int direction_changes = 0;
  double travel_time = 0.0;   ///< s
  double plan_seconds = 0.0;  ///< s
  double picture_width = 0.0, picture_height = 0.0;  ///< px, of small.svg
};

struct PlaceRecord {
  std::string key;                           ///< of what was asked, SHA-256
  std::map<std::string, std::string> files;  ///< beside it: name → SHA-256
  PlaceFigures figures;
};

/// The text carries its own SHA-256, so that one that was cut off or changed is not believed.
std::string place_record_json(const PlaceRecord& record);
/// Empty where it is not whole, was changed, or is of another format.
std::optional<PlaceRecord> parse_place_record(const std::string& text);

struct CheckCounts {
  std::size_t places = 0, solved = 0, not_solved = 0, planned = 0, taken_over = 0, not_reached = 0;
};
/// The whole table as JSON, in the order given.
std::string check_json(const std::vector<PlaceFigures>& rows, const std::vector<std::string>& folders, const CheckCounts& counts, const std::string& version);

}  // namespace waywright
