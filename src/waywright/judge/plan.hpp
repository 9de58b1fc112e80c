// The judged result: what a plan file holds. One type for every planner, for imported paths and for verification.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/judge/field_picture.hpp"
#include "waywright/judge/search_picture.hpp"
#include "waywright/metrics/metrics.hpp"
#include "waywright/path/path.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

struct Timing {
  double load = 0.0, prepare = 0.0, plan = 0.0, prove = 0.0;  ///< s
};

struct Effort {
  std::int64_t evaluations = 0;  ///< candidate paths; of a sampling planner: candidate motions
  std::int64_t expansions = 0;   ///< states that a search expanded
};

/// Something that was tried and not taken (or taken): a side, a form, a second choice.
struct Alternative {
  std::string name;            ///< "left side", "right side", "Reeds-Shepp, RRTConnect"
  bool chosen = false;
  std::optional<double> cost;  ///< of the planner's objective; absent where nothing feasible was found
  std::string outcome;         ///< one sentence
  std::vector<Pose> poses;     ///< best path found, for the picture; may be empty
  Ring zone;                   ///< transition zone, for the picture; may be empty
  bool is_length = false;      ///< its cost is the path's length, m
  bool was_driven = false;     ///< not tried, but what a plan that was being driven had left
};

/// What branch and bound showed of the planner's objective.
struct Optimality {
  double cost = 0.0;         ///< of the answer
  double lower_bound = 0.0;  ///< nothing of the kind that was searched costs less
  std::int64_t boxes = 0;    ///< parts of the space that were bounded
  double gap() const { return lower_bound > 0.0 ? cost / lower_bound - 1.0 : 0.0; }  ///< the answer is at most this share above the optimum
};

/// One leg of a mission: its share of the plan, and what was proven of it.
struct LegResult {
  std::string name;  ///< as given
  std::string load;  ///< carried on it; empty: none
  std::string planner;
  Parameters parameters;
  Status status = Status::no_path;
  std::string reason;
  Pose start{}, end{};      ///< of the vehicle
  bool has_path = false;    ///< else there are no figures
  std::size_t pieces = 0;   ///< of the plan's path, in order; 0 where the plan has none
  std::size_t samples = 0;
  Effort effort;
  Metrics metrics;
  Certificate certificate;
  std::string tightest_obstacle;
  std::vector<Sample> driven;  ///< where the mission came no further than a later leg: this one's path, for the picture
};

/// How the order of a mission's legs was chosen, by the lengths of the ways between their places.
struct VisitingOrder {
  std::vector<std::size_t> given_as;   ///< where each leg, in the order driven, stood in the mission as it was given
  double length = 0.0;                 ///< m, of the order by those lengths
  std::optional<double> given_length;  ///< m, of the order given; empty where it cannot be driven
  double lower_bound = 0.0;            ///< m; no order is shorter
  bool is_exact = false;               ///< it is the shortest of all
  std::int64_t ways = 0;               ///< planned between places
  std::int64_t ways_missing = 0;       ///< of them, where the planner found none that is proven
  double gap() const { return lower_bound > 0.0 ? length / lower_bound - 1.0 : 0.0; }  ///< it is at most this share longer than the shortest
};

/// The vehicle stands for a while to let a moving obstacle pass.
struct Wait {
  double s = 0.0;             ///< m
  Pose pose{};
  double from = 0.0, until = 0.0;  ///< s
  std::size_t obstacle = 0;   ///< index into the scenario's `moving`
  double ahead = 0.0;         ///< m of way from here to where the obstacle comes in the way
  bool stays = false;         ///< it has not passed: the way leads around it from here on
  bool is_wanted = false;     ///< by the planner that found the way, not by the rule of waits.hpp: `ahead` is not told
};

/// What no timing of a path gets past.
struct Hindrance {
  enum class Kind {
    cannot_stop,  ///< the vehicle would meet it before it stands
    comes,        ///< it comes to where the vehicle can stand at the latest
    stands,       ///< it stays in the way
  };
  Kind kind = Kind::stands;
  std::size_t obstacle = 0;
  double s = 0.0;          ///< m, where the vehicle stands then, or would
  double from = 0.0;       ///< s, when it comes to stand there
  double ahead = 0.0;      ///< m of way to where it is hindered
  double braking = 0.0;    ///< m, that it needs to come to rest; 0 where it stands
};

/// Of a plan that was made while another one was driven: for pictures; in no file.
struct Replanned {
  std::vector<Pose> driven;      ///< of the old plan, up to where the vehicle is
  std::vector<Ring> obstacles;   ///< what appeared: polygons, and points as rings of one
  std::vector<Polyline> lines;
};

struct Plan {
  std::string version;
  Status status = Status::no_path;
  std::string reason;  ///< empty where solved
  bool reproducible = true;
  Scenario scenario;  ///< as used, defaults filled in
  std::string planner;
  Parameters parameters;  ///< all of the planner's, defaults filled in
  std::uint64_t seed = 1;
  Timing timing;
  Effort effort;
  Path path;                    ///< empty where there is none
  std::vector<Sample> samples;  ///< empty where there is no path
  Metrics metrics;
  Certificate certificate;
  std::string tightest_obstacle;  ///< name of what the certificate's tightest pose is against; empty where there is none
  std::vector<std::string> explanation;
  std::vector<Alternative> alternatives;
  std::optional<Optimality> optimality;
  std::optional<SearchPicture> search;  ///< for pictures; in no file
  std::shared_ptr<const FieldDrawing> field;  ///< likewise; empty: the planner goes down none
  std::optional<Replanned> replanned;   ///< likewise
  std::vector<Wait> waits;              ///< of its samples, for words and pictures; in no file
  std::optional<Hindrance> hindrance;   ///< likewise; then it is not proven
  std::optional<VisitingOrder> order;  ///< where the order of the legs was chosen; in the file's meta
  std::vector<LegResult> legs;  ///< of a mission in legs, as far as it came; else none
};

}  // namespace waywright
