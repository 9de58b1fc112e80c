// Which layers of a drawing are obstacles, boundary, or neither.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/dxf/drawing.hpp"
#include "waywright/dxf/floor_plan.hpp"

namespace waywright::dxf {

enum class Role { obstacle, boundary, annotation, other, off, frozen };

/// True for layers that hold writing by their name: Defpoints, and a word that begins with DIM, TEXT, ANNO, NOTE, … or ends with TEXT.
bool is_annotation(std::string_view name);

/// True for kinds of entities that stand for nothing on the floor: writing, dimensions, hatches, pictures, construction lines.
bool is_annotation_kind(std::string_view kind);

/// A role for each layer. Refuses names that the drawing does not have.
Parsed<std::vector<Role>> roles_of(const Drawing& drawing, const std::string& name, const Options& options);

/// "3 LINE and 2 ARC on A-WALL; 1 LINE on 0", the largest first; "+ 12 more kinds" beyond a length that can be read.
std::string counted(const Counts& counts, const Drawing& drawing);

}  // namespace waywright::dxf
