// What is fuzzed: functions that take any bytes and hold the code to its promises. libFuzzer drives them by coverage, the quick tests
// by seeded mutations.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace waywright::fuzz {

enum class Outcome {
  refused,   ///< with one sentence
  accepted,  ///< and what was made of it kept every promise
};

/// A promise that was not kept. Thrown outside of the code under test, and not caught under libFuzzer: there it is a crash.
struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};
inline void require(bool kept, const std::string& promise) {
  if (!kept) throw Broken{promise};
}

struct Target {
  std::string name;
  Outcome (*run)(const std::string& bytes);
  std::vector<std::string> (*seeds)();
  bool is_json = false;  ///< mutations of the tree reach deeper than those of bytes
};

Outcome run_scenario(const std::string& text);     ///< scenario.json: read, written, read back, prepared
Outcome run_plan(const std::string& text);         ///< plan.json: read, written, read back, verified
Outcome run_poses(const std::string& text);        ///< poses as CSV: read, judged
Outcome run_site(const std::string& text);         ///< stations.csv: read, each row written as a scenario, read back, prepared
Outcome run_obstacles(const std::string& text);    ///< obstacles.json: read, written, read back
Outcome run_whale_config(const std::string& text); ///< a publication's configuration file: read, written as a scenario, read back
Outcome run_image(const std::string& bytes);       ///< PGM and PNG: decoded, encoded, decoded back
Outcome run_ros_map(const std::string& bytes);     ///< a ROS map's yaml, a zero byte, its picture
Outcome run_movingai(const std::string& bytes);    ///< MovingAI's maps: decoded, written, decoded back
Outcome run_svg(const std::string& bytes);         ///< an SVG drawing of polygons: decoded
Outcome run_rmf(const std::string& bytes);         ///< an Open-RMF building: decoded
Outcome run_opentcs(const std::string& bytes);     ///< an openTCS plant model: decoded, its corridors and zones made
Outcome run_trace(const std::string& bytes);       ///< cells made of the bytes: as polygons that hold them all
Outcome run_dxf(const std::string& bytes);         ///< a DXF drawing: read, its blocks and curves expanded, made a map
Outcome run_station(const std::string& bytes);     ///< a docking station made of the bytes: planned, proven, confirmed by brute force

std::vector<std::string> scenario_seeds();
std::vector<std::string> plan_seeds();
std::vector<std::string> poses_seeds();
std::vector<std::string> site_seeds();
std::vector<std::string> obstacles_seeds();
std::vector<std::string> whale_config_seeds();
std::vector<std::string> image_seeds();
std::vector<std::string> ros_map_seeds();
std::vector<std::string> movingai_seeds();
std::vector<std::string> svg_seeds();
std::vector<std::string> rmf_seeds();
std::vector<std::string> opentcs_seeds();
std::vector<std::string> trace_seeds();
std::vector<std::string> dxf_seeds();
std::vector<std::string> station_seeds();

inline const std::vector<Target>& targets() {
  static const std::vector<Target> all{{"scenario", run_scenario, scenario_seeds, true}, {"plan", run_plan, plan_seeds, true},
                                       {"poses", run_poses, poses_seeds},                {"image", run_image, image_seeds},
                                       {"site", run_site, site_seeds},                  {"whale_config", run_whale_config, whale_config_seeds, true},
                                       {"obstacles", run_obstacles, obstacles_seeds, true},
                                       {"ros_map", run_ros_map, ros_map_seeds},          {"movingai", run_movingai, movingai_seeds},          {"svg", run_svg, svg_seeds}, {"rmf", run_rmf, rmf_seeds}, {"opentcs", run_opentcs, opentcs_seeds}, {"trace", run_trace, trace_seeds},
                                                {"dxf", run_dxf, dxf_seeds},                      {"station", run_station, station_seeds}};
  return all;
}

}  // namespace waywright::fuzz
