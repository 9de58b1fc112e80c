// What a drawing holds, by a look at its groups alone: unit, layers, entities of each kind, blocks and how often they are inserted. GDAL
// tells none of this (the unit, the kinds in old files, frozen layers, external references), cuts long blocks and takes any number.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright::dxf {

struct Layer {
  std::string name;  ///< UTF-8
  bool off = false;
  bool frozen = false;
};

/// Number of entities by kind ("LINE") and layer (index).
using Counts = std::map<std::pair<std::string, std::size_t>, double>;

struct Block {
  struct Insert {
    std::size_t block = 0;
    double times = 1.0;  ///< of its array
    double scale = 1.0;  ///< the greater of both
  };
  bool known = false;     ///< defined, not only named
  bool external = false;  ///< a reference to another file, which is not here
  std::vector<Insert> inserts;
  double entities = 0.0;       ///< that can be taken
  Counts left_out;
  double times = 0.0;  ///< instances in model space; 0: not used
  double scale = 0.0;  ///< greatest of any instance
};

struct Drawing {
  int unit = 0;  ///< $INSUNITS; 0: none
  std::vector<Layer> layers;
  std::vector<Block> blocks;  ///< the first is model space
  std::map<std::string, std::size_t> layer_index, block_index;  ///< by name in capitals
  Counts left_out;                 ///< of kinds that are no outlines, in all instances
  double in_paper_space = 0.0, invisible = 0.0, on_frozen_inserts = 0.0, missing_blocks = 0.0, external_blocks = 0.0;
  double expanded = 0.0;         ///< entities that can be taken, in all instances
  Box box{};                     ///< about the points of model space, roughly; of size 0 where there are none
};

/// Refuses a drawing that cannot be read as a whole: not DXF, cut short, numbers that are not finite, blocks that insert themselves, more
/// entities than can be kept.
Parsed<Drawing> scan(std::string_view text, const std::string& name);

/// A drawing of straight lines alone, for GDAL, which inserts its blocks.
struct Cleaned {
  std::string text;  ///< empty where there is nothing to take
  std::vector<std::vector<double>> curves;  ///< the knots' weights of each curve, whose points are a polyline's in the text
};

/// The same drawing with nothing but what can be taken, layers and blocks by number ("0", "L7", "B3"), each entity with a group 100 that
/// holds its kind ("WW ARC~12": the curve 12). Splines are cut into pieces whose hulls are flat within `tolerance` (drawing units).
Parsed<Cleaned> cleaned(std::string_view text, const std::string& name, const Drawing& drawing, double tolerance);

}  // namespace waywright::dxf
