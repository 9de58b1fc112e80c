// For tests: drawings as text, group by group.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace waywright::test {

struct Value {
  int code;
  std::string text;
  Value(int c, const char* v) : code{c}, text{v} {}
  Value(int c, std::string v) : code{c}, text{std::move(v)} {}
  Value(int c, double v) : code{c}, text{fmt::format("{}", v)} {}
  Value(int c, int v) : code{c}, text{fmt::format("{}", v)} {}
};

inline std::string groups(std::initializer_list<Value> values) {
  std::string text;
  for (const Value& v : values) text += fmt::format("{:3}\n{}\n", v.code, v.text);
  return text;
}

struct TestDrawing {
  std::string unit = "4";  ///< $INSUNITS; empty: not there
  std::string layers, blocks, entities;

  void layer(const std::string& name, int flags, int colour) { layers += groups({{0, "LAYER"}, {2, name}, {70, flags}, {62, colour}, {6, "CONTINUOUS"}}); }
  void block(const std::string& name, double x, double y, const std::string& content, int flags = 0) {
    blocks += groups({{0, "BLOCK"}, {8, "0"}, {2, name}, {70, flags}, {10, x}, {20, y}, {30, 0}}) + content + groups({{0, "ENDBLK"}, {8, "0"}});
  }
  std::string text() const {
    const auto section = [](const char* name, const std::string& content) { return groups({{0, "SECTION"}, {2, name}}) + content + groups({{0, "ENDSEC"}}); };
    std::string header = groups({{9, "$ACADVER"}, {1, "AC1015"}});
    if (!unit.empty()) header += groups({{9, "$INSUNITS"}, {70, unit}});
    return section("HEADER", header) + section("TABLES", groups({{0, "TABLE"}, {2, "LAYER"}}) + layers + groups({{0, "ENDTAB"}})) + section("BLOCKS", blocks) +
           section("ENTITIES", entities) + groups({{0, "EOF"}});
  }
};

inline std::string line(const std::string& layer, double x0, double y0, double x1, double y1) {
  return groups({{0, "LINE"}, {8, layer}, {10, x0}, {20, y0}, {11, x1}, {21, y1}});
}
struct Bent {
  double x, y, bulge = 0.0;
};
inline std::string polyline(const std::string& layer, bool closed, const std::vector<Bent>& corners) {
  std::string text = groups({{0, "LWPOLYLINE"}, {8, layer}, {90, static_cast<int>(corners.size())}, {70, closed ? 1 : 0}});
  for (const Bent& c : corners) text += groups({{10, c.x}, {20, c.y}, {42, c.bulge}});
  return text;
}
inline std::string box(const std::string& layer, double x0, double y0, double x1, double y1) { return polyline(layer, true, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}); }
inline std::string circle(const std::string& layer, double x, double y, double r) { return groups({{0, "CIRCLE"}, {8, layer}, {10, x}, {20, y}, {40, r}}); }

}  // namespace waywright::test
