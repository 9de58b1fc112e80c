// The plant model of openTCS: its model editor's .xml.
#pragma once

#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/map/lane_graph.hpp"

namespace waywright {

struct PlantModel {
  LaneGraph lanes;
  std::vector<std::string> notes;  ///< what was taken, left out or taken otherwise, in plain sentences
};

/// Points as places, paths as lanes, locations as stations, vehicles' boxes, in metres. Of obstacles an openTCS model knows nothing. Courses of paths are those that the model draws: straight lines, Bézier curves (as chords within 2 cm) and polylines; of other forms (elbows, slanted ones) the
/// straight line. A path is driven forwards where its maxVelocity is over 0, back where maxReverseVelocity is; locked ones are left out. Models of version 4 to 7 are
/// read; what is not about the floor (peripherals, blocks, types, layers, properties) is passed over.
Parsed<PlantModel> decode_opentcs_map(const std::string& bytes, const std::string& name);

}  // namespace waywright
