// A drawing with nothing in it but what can be taken, for GDAL.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "waywright/dxf/entity.hpp"

namespace waywright::dxf {
namespace {

constexpr double least_share = 0.01;  // flatness of a spline's pieces, of its size

/// Groups that say where an entity is and what form it has. Names, styles, handles and other programs' data are not among them.
bool places(int code) { return (code >= 10 && code < 60) || (code >= 70 && code < 80) || code == 90 || (code >= 210 && code < 240); }

class Cleaner {
 public:
  Cleaner(const std::string& name, const Drawing& drawing, double tolerance) : name_{name}, drawing_{drawing}, tolerance_{tolerance} {
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

  Cleaned finish() {
    if (!any_) return {};
    if (!in_entities_) out_ += "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    out_ += "0\nENDSEC\n0\nEOF\n";
    return {std::move(out_), std::move(curves_)};
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
    if (item.type == "LWPOLYLINE" && !item.find(10)) return std::nullopt;  // of no corners: GDAL would refuse the whole drawing
    any_ = true;
    if (item.type == "SPLINE") return take_spline(item, token);
    if (is_curved(item)) {
      // An ellipse's points are the world's already; those of the others lie in the plane that the extrusion gives.
      take_curve(curve_of(item), token, fmt::format("{}~", item.type), item.type == "ELLIPSE" ? nullptr : &item);
      return std::nullopt;
    }
    begin(item.type, token, std::string{item.type});
    if (item.type == "POLYLINE") return take_vertices(item, token);
    for (const Group& group : item.groups) {
      if (places(group.code) && group.code != 42) put(group.code, group.value);
    }
    return std::nullopt;
  }

  /// Its points as those of a polyline; what they are is kept beside. GDAL transforms points, which does the same to the curve.
  void take_curve(const Chain& chain, const std::string& layer, const std::string& tag, const Item* plane) {
    begin("LWPOLYLINE", layer, fmt::format("{}{}", tag, curves_.size()));
    put(90, fmt::format("{}", chain.size()));
    put(70, "0");
    if (plane != nullptr) {
      const int height = plane->type == "LWPOLYLINE" ? 38 : 30;
      put(38, fmt::format("{}", number(*plane, height, 0.0)));
      for (const int code : {210, 220, 230}) put(code, fmt::format("{}", number(*plane, code, code == 230 ? 1.0 : 0.0)));
    }
    std::vector<double>& weights = curves_.emplace_back();
    weights.reserve(chain.size());
    for (const Knot& knot : chain) {
      fmt::format_to(std::back_inserter(out_), "10\n{}\n20\n{}\n", knot.at.x, knot.at.y);
      weights.push_back(knot.weight);
    }
  }

  void begin(std::string_view type, const std::string& layer, const std::string& tag) {
    put(0, type);
    put(8, layer);
    out_ += "100\nWW " + tag + "\n";
  }

  std::optional<InputError> take_vertices(const Item& item, const std::string& layer) {
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
          if (code == 10 || code == 20 || code == 30) put(code, item.groups[k].value);
        }
      }
      i = end;
    }
    put(0, "SEQEND");
    return std::nullopt;
  }

  std::optional<InputError> take_spline(const Item& item, const std::string& layer) {
    const double scale = std::max(block_->scale, 1e-9);
    const auto wrong = [&](std::string problem, const char* allowed) {
      return InputError{name_, fmt::format("line {} (SPLINE on layer {})", item.line, one_line(std::string{item.text(8)})), std::move(problem), allowed};
    };
    if (const SplineCurve curve = spline_of(item); !curve.controls.empty()) {
      // A closed curve that is small against the tolerance keeps a form, too.
      const Box box = bounding_box(curve.controls);
      auto found = pieces(curve, std::min(tolerance_ / scale, std::max(least_share * norm(box.high - box.low), 1e-12)));
      if (const auto* problem = std::get_if<std::string>(&found)) {
        return wrong(*problem, "a spline of degree 1 to 15 with n + degree + 1 rising knots for n control points of positive weight");
      }
      return take_curve(std::get<Chain>(found), layer, "SPLINE~", nullptr), std::nullopt;
    }
    const std::vector<Vec2> corners = fit_points_of(item);
    if (corners.size() < 2) return wrong("the spline has no points", "control points or fit points");
    begin("LWPOLYLINE", layer, "SPLINE?");
    put(90, fmt::format("{}", corners.size()));
    put(70, (whole_number(item, 70, 0) & 1) != 0 ? "1" : "0");
    for (const Vec2 p : corners) fmt::format_to(std::back_inserter(out_), "10\n{}\n20\n{}\n", p.x, p.y);
    return std::nullopt;
  }

  const std::string& name_;
  const Drawing& drawing_;
  double tolerance_;
  const Block* block_ = nullptr;
  bool in_entities_ = false, any_ = false;
  std::string out_;
  std::vector<std::vector<double>> curves_;
};

}  // namespace

Parsed<Cleaned> cleaned(std::string_view text, const std::string& name, const Drawing& drawing, double tolerance) {
  Cleaner cleaner{name, drawing, tolerance};
  if (auto error = walk(text, name, [&](Section section, const Item& item) { return cleaner.take(section, item); })) return tl::unexpected{*error};
  return cleaner.finish();
}

}  // namespace waywright::dxf
