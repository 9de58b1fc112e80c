// One function a command. Each parses nothing: main.cpp has done that; it calls the library and prints.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/dxf/floor_plan.hpp"
#include "waywright/io/scenario_io.hpp"

namespace waywright::app {

inline constexpr int solved = 0;
inline constexpr int not_solved = 1;
inline constexpr int bad_input = 2;

/// While one lives, SIGINT and SIGTERM raise a flag, for work that stops in order and keeps what is finished; should it not end within
/// some seconds, or the signal come again, the program ends. At all other times these signals end the program at once, which is safe:
/// files appear whole or not at all.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  const std::atomic<bool>* flag() const;
};

/// Prints the one sentence; returns the exit status 2.
int complain(const InputError& error);
/// Says something worth knowing on standard error, where results go on; the same sentence once.
void note(const std::string& sentence);
/// What was repaired on loading, and what else a user should know of a scenario or a map before trusting a result.
void note_all(const std::vector<std::string>& repairs, const std::vector<std::string>& warnings);
/// Prints a result on standard output, control characters of names replaced; false where it cannot take it: said, unless the
/// reader has gone.
bool print(const std::string& text);
/// The same for JSON, which escapes them itself: bytes as they are.
bool print_raw(const std::string& text);

/// The folder of the bundled examples: beside the installed program, or in the source tree it was built from.
std::filesystem::path examples_folder();

struct PlanArguments {
  std::filesystem::path scenario;
  std::optional<std::filesystem::path> out;
  std::string planner;
  std::vector<std::string> set;
  std::optional<std::uint64_t> seed;
  bool json = false;
};
int plan(const PlanArguments& arguments);

struct ParetoArguments {
  PlanArguments plan;
  int points = 12;  ///< plans, at most
};
int pareto(const ParetoArguments& arguments);

/// `waywright` without a command: plans the bundled docking example.
int plan_example();

int verify(const std::filesystem::path& plan);

struct ReplanArguments {
  std::filesystem::path plan;
  std::optional<std::string> at;     ///< s after the plan's start
  std::optional<std::string> after;  ///< or m after it
  std::optional<std::filesystem::path> obstacles;  ///< obstacles.json: what has been seen
  std::optional<std::string> shelf, goal, pose;  ///< "X,Y,HEADING" as measured; absent: as it was
  std::optional<std::filesystem::path> out;
  bool json = false;
};
int replan(const ReplanArguments& arguments);

struct ControlsArguments {
  std::filesystem::path plan;
  std::optional<std::filesystem::path> out;
  std::string period = "0.05";    ///< s
  std::string method = "exact";   ///< or "woa"
  std::vector<std::string> set;
  std::optional<std::uint64_t> seed;
  bool json = false;
};
int controls(const ControlsArguments& arguments);

struct ImportArguments {
  std::filesystem::path path, scenario;
  std::optional<std::filesystem::path> out;
};
int import(const ImportArguments& arguments);

struct CompareArguments {
  std::vector<std::filesystem::path> scenarios;
  std::string planners;
  std::vector<std::string> set;
  std::vector<std::string> suite;  ///< not supported yet
  int runs = 1;
  unsigned threads = 0;
  std::optional<std::int64_t> evaluations;
  std::filesystem::path out = "waywright-out/compare";
};
int compare(const CompareArguments& arguments);

struct ReproduceArguments {
  std::string what;  ///< whose experiments
  std::optional<std::filesystem::path> out;
  std::optional<int> runs;  ///< searches each: safe_astar 5, for their median time; rrt_woa 100 seeds a map, as published
};
int reproduce(const ReproduceArguments& arguments);

struct CheckArguments {
  std::vector<std::filesystem::path> inputs;  ///< one table of stations, or scenario files
  std::optional<std::filesystem::path> map, vehicle;
  std::optional<double> clearance;  ///< m, of places that name none
  std::string planner;
  std::vector<std::string> set;
  std::optional<std::uint64_t> seed;
  std::filesystem::path out = "waywright-out/check";
  unsigned threads = 0;
  bool fresh = false;
  bool json = false;
};
int check(const CheckArguments& arguments);

int list(const std::string& what);
struct MapArguments {
  std::filesystem::path file;
  std::optional<std::filesystem::path> out;
  std::vector<std::string> align;  ///< "X,Y=X,Y": on the map, in the world
  dxf::Options drawing;                          ///< of a DXF alone
  std::string obstacle_layers;                   ///< "A,B"
  bool about_drawing = false;                    ///< one of the options for a DXF was given
  std::optional<std::filesystem::path> overlay;  ///< a map that is drawn below this one
  std::string overlay_unit;                      ///< of a DXF there
  std::optional<std::filesystem::path> picture;  ///< SVG to write
  CellMapOptions cells;
};
int map(const MapArguments& arguments);

struct GenerateArguments {
  std::string name;
  std::filesystem::path out;
  std::uint64_t seed = 1;
  std::optional<int> boxes;
  std::optional<int> count;                      ///< of stations
  std::optional<std::filesystem::path> vehicle;  ///< that the stations are for
};
int generate(const GenerateArguments& arguments);

}  // namespace waywright::app
