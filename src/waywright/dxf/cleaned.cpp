// A drawing with nothing in it but what can be taken, for GDAL.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "waywright/dxf/entity.hpp"

namespace waywright::dxf {
namespace {

/// Groups that say where an entity is and what form it has. Names, styles, handles and other programs' data are not among them.
bool places(int code) { return (code >= 10 && code < 60) || (code >= 70 && code < 80) || code == 90 || (code >= 210 && code < 240); }

class Cleaner {
 public:
  Cleaner(const std::string& name, const Drawing& drawing, double tolerance, double above, double up_to)
      : name_{name}, drawing_{drawing}, tolerance_{tolerance}, above_{above}, up_to_{up_to} {
    out_ = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1021\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n";
  }

  std::optional<InputError> take(Section section, const Item& item) {
    if (section != Section::blocks && section != Section::entities) return std::nullopt;
    if (section == Section::entities && !in_entities_) {
      out_ += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
      in_entities_ = true;
    }
    if (section == Section::blocks && item.type == "BLOCK") {
      const std::size_t block = drawing_.block_index.at(capitals(item.text(2)));
      block_ = drawing_.blocks[block].times > 0.0 && !drawing_.blocks[block].external ? &drawing_.blocks[block] : nullptr;
      if (block_ != nullptr) {
        put(0, "BLOCK");
        put(8, "0");
        put(2, fmt::format("B{}", block));
        put(70, "0");
        for (const int code : {10, 20, 30}) put(code, fmt::format("{}", number(item, code, 0.0)));
      }
      return std::nullopt;
    }
    if (section == Section::blocks && item.type == "ENDBLK") {
      if (block_ != nullptr) put(0, "ENDBLK");
      block_ = nullptr;
      return std::nullopt;
    }
    if (section == Section::entities) block_ = &drawing_.blocks.front();
    return block_ != nullptr ? take_entity(item) : std::nullopt;
  }

  std::string finish() {
    if (!any_) return {};
    if (!in_entities_) out_ += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    out_ += "0\nENDSEC\n0\nEOF\n";
    return std::move(out_);
  }

 private:
  void put(int code, std::string_view value) { fmt::format_to(std::back_inserter(out_), "{}\n{}\n", code, value); }

  std::optional<InputError> take_entity(const Item& item) {
    if (whole_number(item, 67, 0) == 1 || whole_number(item, 60, 0) == 1) return std::nullopt;
    const std::string key = layer_of(item);
    const std::size_t layer = drawing_.layer_index.at(key);
    const std::string token = layer == 0 ? "0" : fmt::format("L{}", layer);
    if (item.type == "INSERT") {
      if (drawing_.layers[layer].frozen) return std::nullopt;  // its block may be named nowhere else
      const std::size_t block = drawing_.block_index.at(capitals(item.text(2)));
      if (!drawing_.blocks[block].known || drawing_.blocks[block].external) return std::nullopt;
      begin(item.type, token, "INSERT");
      put(2, fmt::format("B{}", block));
      for (const Group& group : item.groups) {
        if (group.code == 70 || group.code == 71) put(group.code, fmt::format("{}", std::max(1, whole_number(item, group.code, 1))));
        else if (places(group.code)) put(group.code, group.value);
      }
      return std::nullopt;
    }
    if (!is_outline(item)) return std::nullopt;
    const double flat = tolerance_ / std::max(block_->scale, 1e-9);
    const double radius = block_->scale * largest_radius(item, flat);
    if (!(radius > above_) || radius > up_to_) return std::nullopt;
    if (item.type == "LWPOLYLINE" && !item.find(10)) return std::nullopt;  // of no corners: GDAL would refuse the whole drawing
    any_ = true;
    if (item.type == "SPLINE") return take_spline(item, token);
    begin(item.type, token, fmt::format("{}{}", item.type, is_curved(item) ? "~" : ""));
    if (item.type == "POLYLINE") return take_vertices(item, token, flat);
    if (item.type == "LWPOLYLINE") return take_corners(item, flat);
    for (const Group& group : item.groups) {
      if (places(group.code)) put(group.code, group.value);
    }
    return std::nullopt;
  }

  /// Arcs that are straight within the tolerance become so: their radius, which may be any, would ask for tiny chords of all others.
  std::optional<InputError> take_corners(const Item& item, double flat) {
    const std::vector<bool> arcs = arcs_of(item, flat);
    std::size_t corners = 0;
    for (const Group& group : item.groups) {
      corners += group.code == 10 ? 1 : 0;
      const bool is_flat = group.code == 42 && (corners == 0 || !arcs[corners - 1]);
      if (group.code == 90) put(90, fmt::format("{}", arcs.size()));
      else if (places(group.code) && !is_flat) put(group.code, group.value);
    }
    return std::nullopt;
  }

  void begin(std::string_view type, const std::string& layer, const std::string& tag) {
    put(0, type);
    put(8, layer);
    out_ += "100\nWW " + tag + "\n";
  }

  std::optional<InputError> take_vertices(const Item& item, const std::string& layer, double flat) {
    const std::vector<bool> arcs = arcs_of(item, flat);
    std::size_t vertex = 0;
    put(66, "1");
    std::size_t i = 0;
    for (; i < item.groups.size() && item.groups[i].code != 0; ++i) {
      if (places(item.groups[i].code)) put(item.groups[i].code, item.groups[i].value);
    }
    while (i < item.groups.size()) {
      std::size_t end = i + 1;
      bool frame = false;  // a control point of a smoothed polyline, which is not on it
      for (; end < item.groups.size() && item.groups[end].code != 0; ++end) {
        const Group& group = item.groups[end];
        if (group.code == 70) frame = (static_cast<int>(std::clamp(number_from(group.value).value_or(0.0), 0.0, 65535.0)) & 16) != 0;
      }
      if (!frame) {
        put(0, "VERTEX");
        put(8, layer);
        for (std::size_t k = i + 1; k < end; ++k) {
          const int code = item.groups[k].code;
          if (code == 10 || code == 20 || code == 30 || (code == 42 && arcs[vertex])) put(code, item.groups[k].value);
        }
      }
      ++vertex;
      i = end;
    }
    put(0, "SEQEND");
    return std::nullopt;
  }

  std::optional<InputError> take_spline(const Item& item, const std::string& layer) {
    const double scale = std::max(block_->scale, 1e-9);
    std::vector<Vec2> corners = fit_points_of(item);
    std::string tag = "SPLINE?";  // by its fit points alone
    if (const SplineCurve curve = spline_of(item); !curve.controls.empty()) {
      auto found = chords(curve, tolerance_ / scale);
      if (const auto* problem = std::get_if<std::string>(&found)) {
        return InputError{name_, fmt::format("line {} (SPLINE on layer {})", item.line, one_line(std::string{item.text(8)})), *problem,
                          "a spline of degree 1 to 15 with n + degree + 1 rising knots for n control points of positive weight"};
      }
      corners = std::move(std::get<0>(found));
      tag = "SPLINE";
    }
    if (corners.size() < 2) {
      return InputError{name_, fmt::format("line {} (SPLINE on layer {})", item.line, one_line(std::string{item.text(8)})), "the spline has no points",
                        "control points or fit points"};
    }
    begin("LWPOLYLINE", layer, tag);
    put(90, fmt::format("{}", corners.size()));
    const bool closed = tag == "SPLINE?" && (whole_number(item, 70, 0) & 1) != 0;
    put(70, closed ? "1" : "0");
    for (const Vec2 p : corners) fmt::format_to(std::back_inserter(out_), "10\n{}\n20\n{}\n", p.x, p.y);
    return std::nullopt;
  }

  const std::string& name_;
  const Drawing& drawing_;
  double tolerance_, above_, up_to_;
  const Block* block_ = nullptr;
  bool in_entities_ = false, any_ = false;
  std::string out_;
};

}  // namespace

Parsed<std::string> cleaned(std::string_view text, const std::string& name, const Drawing& drawing, double tolerance, double above, double up_to) {
  Cleaner cleaner{name, drawing, tolerance, above, up_to};
  if (auto error = walk(text, name, [&](Section section, const Item& item) { return cleaner.take(section, item); })) return tl::unexpected{*error};
  return cleaner.finish();
}

}  // namespace waywright::dxf
