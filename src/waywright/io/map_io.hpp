// Maps from files of the field's formats.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// A file that went into a map, for the record in the plan.
struct MapFile {
  std::string path;  ///< as named in the scenario or yaml
  std::string sha256;
};

struct LoadedGrid {
  CellGrid grid;
  std::vector<MapFile> files;
  std::vector<std::string> notes;
};

/// ROS map_server yaml with its pgm or png: trinary, scale and raw modes (free, occupied, unknown by thresholds), negate,
/// rotated origin. `unknown_is_free` lets unknown cells be driven on. The image's path is relative to the yaml.
Parsed<LoadedGrid> load_ros_map(const std::filesystem::path& yaml, bool unknown_is_free);

/// A PGM or PNG picture: cells darker than `occupied_below` (of 1.0 = white) are occupied.
Parsed<LoadedGrid> load_image_map(const std::filesystem::path& image, double resolution, const Pose& origin,
                                  double occupied_below);

/// A map of MovingAI's benchmarks: a character a cell, the first row at the top; `.`, `G` and `S` are free, `@`, `O`, `T` and `W` blocked. `cell` in m, > 0; the
/// lower left corner is the origin.
Parsed<LoadedGrid> load_movingai_map(const std::filesystem::path& file, double cell);
/// The same from a file's bytes.
Parsed<LoadedGrid> decode_movingai_map(const std::string& bytes, const std::string& name, double cell);

/// Rigid transform of everything in a map (grids: their origin).
void transform(Map& map, const Pose& pose);

/// Rigid transform that brings `from` points onto `to` points in the least-squares sense (Umeyama 1991 without scale), with
/// residuals in metres. Refused for fewer than 2 pairs or coinciding points.
Parsed<Alignment> align(const std::vector<Vec2>& from, const std::vector<Vec2>& to);

}  // namespace waywright
