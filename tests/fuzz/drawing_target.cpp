// DXF drawings through the group reader, GDAL and the making of a map.
#include <algorithm>

#include "tests/fuzz/sentences.hpp"
#include "tests/fuzz/target.hpp"
#include "waywright/dxf/floor_plan.hpp"
#include "waywright/dxf/test_drawing.hpp"

namespace waywright::fuzz {
namespace {

using namespace waywright::test;

bool is_kept(const std::vector<Ring>& rings) {
  return std::all_of(rings.begin(), rings.end(), [](const Ring& ring) {
    const RingRepair again = repair_ring(ring);
    return !again.refused && again.mended.empty();
  });
}

}  // namespace

Outcome run_dxf(const std::string& bytes) {
  dxf::Options options;
  if (bytes.size() % 3 != 0) options.unit = "mm";
  if (bytes.size() % 2 != 0) options.boundary_layer = "B";
  const auto plan = dxf::read_floor_plan(bytes, "plan.dxf", options);
  if (!plan) {
    require_sentence(plan.error());
    return Outcome::refused;
  }
  require(is_kept(plan->boundaries) && is_kept(plan->obstacles), "polygons are simple and counter-clockwise");
  require(plan->boundaries.size() + plan->obstacles.size() + plan->lines.size() > 0, "a map holds something");
  for (const Polyline& line : plan->lines) {
    require(line.size() > 1 && std::all_of(line.begin(), line.end(), [](Vec2 p) { return is_finite(p); }), "lines have two finite points or more");
  }
  for (const std::string& note : plan->notes) {
    require(std::none_of(note.begin(), note.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }), "a note is one line of text: " + note);
  }
  return Outcome::accepted;
}

std::vector<std::string> dxf_seeds() {
  TestDrawing all;
  all.layer("B", 0, 7);
  all.layer("ICE", 1, 7);
  all.layer("DARK", 0, -7);
  all.block("X", 10, 0, line("0", 0, 0, 900, 50) + circle("W", 5, 5, 400) + line("ICE", 0, 0, 1, 1));
  all.block("Y", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "X"}, {10, 5}, {20, 0}, {41, 2}, {42, 0.5}, {50, 90}}));
  all.entities = box("B", 0, 0, 20000, 9000) + groups({{0, "INSERT"}, {8, "M"}, {2, "Y"}, {10, 3000}, {20, 3000}, {41, -1}, {42, 1}, {50, 30}, {70, 2}, {71, 2}, {44, 2000}, {45, 2000}}) +
                 polyline("W", true, {{100, 100, 1}, {900, 100, -0.5}, {500, 800, 0}}) + groups({{0, "TEXT"}, {8, "W"}, {1, "x"}});
  TestDrawing curves;
  curves.layer("B", 0, 7);
  curves.entities = line("B", 0, 0, 9000, 0) + line("B", 9000, 0, 9000, 5000) + line("B", 9000, 5000, 0, 0) +
                    groups({{0, "ARC"}, {8, "W"}, {10, 0}, {20, 0}, {40, 1000}, {50, 350}, {51, 10}, {210, 0}, {220, 0}, {230, -1}}) +
                    groups({{0, "ELLIPSE"}, {8, "W"}, {10, 0}, {20, 0}, {11, 3000}, {21, 10}, {40, 0.2}, {41, 0}, {42, 6.283}}) +
                    groups({{0, "SPLINE"}, {8, "W"}, {70, 8}, {71, 2}, {72, 6}, {73, 3}, {40, 0}, {40, 0}, {40, 0}, {40, 1}, {40, 1}, {40, 1}, {10, 0}, {20, 0}, {10, 500}, {20, 900}, {10, 900}, {20, 0}}) +
                    groups({{0, "SPLINE"}, {8, "W"}, {71, 3}, {74, 2}, {11, 0}, {21, 0}, {11, 500}, {21, 900}}) +
                    groups({{0, "POLYLINE"}, {8, "W"}, {66, 1}, {70, 1}, {0, "VERTEX"}, {10, 0}, {20, 0}, {42, 0.3}, {0, "VERTEX"}, {10, 700}, {20, 0}, {0, "VERTEX"}, {10, 700}, {20, 700}, {0, "SEQEND"}}) +
                    groups({{0, "SOLID"}, {8, "W"}, {10, 0}, {20, 0}, {11, 400}, {21, 0}, {12, 0}, {22, 400}, {13, 400}, {23, 400}});
  return {all.text(), curves.text()};
}

}  // namespace waywright::fuzz
