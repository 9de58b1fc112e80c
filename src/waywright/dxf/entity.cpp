#include "waywright/dxf/entity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace waywright::dxf {
namespace {

constexpr double largest_number = 1e12;  // drawing units: a kilometre in micrometres is 1e9
constexpr double least_bulge = 1e-9;     // under it an arc rises half a micrometre over a kilometre
constexpr double largest_angle = 1e6;    // GDAL turns angles back one turn at a time

constexpr std::array<std::string_view, 9> outlines{"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "SOLID", "TRACE"};

bool is_angle(std::string_view type, int code) {
  return ((type == "ARC" || type == "INSERT") && (code == 50 || code == 51)) || (type == "ELLIPSE" && (code == 41 || code == 42));
}

struct Corner {
  Vec2 at{};
  double bulge = 0.0;
};

std::vector<Corner> corners_of(const Item& polyline) {
  std::vector<Corner> corners;
  const bool light = polyline.type == "LWPOLYLINE";
  bool in_vertex = light;
  for (const Group& group : polyline.groups) {
    if (group.code == 0) {
      in_vertex = true;
      corners.emplace_back();
    }
    if (!in_vertex) continue;
    if (light && group.code == 10) corners.emplace_back();
    if (corners.empty()) continue;
    if (group.code == 10) corners.back().at.x = number_from(group.value).value_or(0.0);
    if (group.code == 20) corners.back().at.y = number_from(group.value).value_or(0.0);
    if (group.code == 42) corners.back().bulge = number_from(group.value).value_or(0.0);
  }
  return corners;
}

std::vector<Vec2> points_of(const Item& entity, int code) {
  std::vector<Vec2> points;
  for (const Group& group : entity.groups) {
    if (group.code == code) points.push_back({number_from(group.value).value_or(0.0), 0.0});
    if (group.code == code + 10 && !points.empty()) points.back().y = number_from(group.value).value_or(0.0);
  }
  return points;
}

std::vector<double> numbers_of(const Item& entity, int code) {
  std::vector<double> numbers;
  for (const Group& group : entity.groups) {
    if (group.code == code) numbers.push_back(number_from(group.value).value_or(0.0));
  }
  return numbers;
}

}  // namespace

std::string capitals(std::string_view text) {
  std::string out{text};
  for (char& c : out) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return out;
}

std::string layer_of(const Item& entity) {
  const std::string_view layer = entity.text(8);
  return layer.empty() ? "0" : capitals(layer);
}

bool is_outline(const Item& entity) {
  if (std::find(outlines.begin(), outlines.end(), entity.type) == outlines.end()) return false;
  constexpr int meshes = 16 | 64;
  return entity.type != "POLYLINE" || (whole_number(entity, 70, 0) & meshes) == 0;
}

bool is_curved(const Item& entity) {
  if (entity.type == "LWPOLYLINE" || entity.type == "POLYLINE") {
    const auto corners = corners_of(entity);
    return std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return c.bulge != 0.0; });
  }
  return entity.type != "LINE" && entity.type != "SOLID" && entity.type != "TRACE";
}

std::optional<InputError> check_numbers(const Item& entity, const std::string& file) {
  for (const Group& group : entity.groups) {
    if (group.code < 10 || (group.code >= 60 && group.code < 210) || group.code >= 240) continue;
    const auto value = number_from(group.value);
    const double most = is_angle(entity.type, group.code) ? largest_angle : largest_number;
    if (value && std::abs(*value) <= most) continue;
    std::string shown{group.value.substr(0, 40)};
    return InputError{file, fmt::format("line {} ({} on layer {})", group.line, one_line(std::string{entity.type}), one_line(std::string{entity.text(8)})),
                      value ? fmt::format("{} is out of range", *value) : fmt::format("\"{}\" is not a finite number", one_line(std::move(shown))),
                      fmt::format("a number within ±{:g}", most)};
  }
  return std::nullopt;
}

double number(const Item& entity, int code, double otherwise) {
  const auto text = entity.find(code);
  return text ? number_from(*text).value_or(otherwise) : otherwise;
}

int whole_number(const Item& entity, int code, int otherwise) {
  const auto text = entity.find(code);
  int value = otherwise;
  if (text) std::from_chars(text->data(), text->data() + text->size(), value);
  return value;
}

namespace {

/// |bulge| and chord of the arc that begins at a corner.
std::pair<double, double> arc_at(const std::vector<Corner>& corners, std::size_t i) {
  const double bulge = std::abs(corners[i].bulge);
  return {bulge < least_bulge ? 0.0 : bulge, distance(corners[i].at, corners[(i + 1) % corners.size()].at)};
}

bool rises(double bulge, double chord, double flat) { return 0.5 * chord * bulge > flat; }

}  // namespace

double largest_radius(const Item& entity, double flat) {
  if (entity.type == "ARC" || entity.type == "CIRCLE") return std::abs(number(entity, 40, 0.0));
  if (entity.type == "ELLIPSE") return norm({number(entity, 11, 0.0), number(entity, 21, 0.0)}) * std::max(1.0, std::abs(number(entity, 40, 1.0)));
  if (entity.type != "LWPOLYLINE" && entity.type != "POLYLINE") return 0.0;
  double radius = 0.0;
  const auto corners = corners_of(entity);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [bulge, chord] = arc_at(corners, i);
    if (rises(bulge, chord, flat)) radius = std::max(radius, 0.25 * chord * (bulge + 1.0 / bulge));
  }
  return radius;
}

std::vector<bool> arcs_of(const Item& polyline, double flat) {
  const auto corners = corners_of(polyline);
  std::vector<bool> arcs(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [bulge, chord] = arc_at(corners, i);
    arcs[i] = rises(bulge, chord, flat);
  }
  return arcs;
}

SplineCurve spline_of(const Item& entity) {
  return {whole_number(entity, 71, 3), numbers_of(entity, 40), points_of(entity, 10), numbers_of(entity, 41)};
}

std::vector<Vec2> fit_points_of(const Item& entity) { return points_of(entity, 11); }

}  // namespace waywright::dxf
