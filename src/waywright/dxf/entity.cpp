#include "waywright/dxf/entity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "waywright/core/angle.hpp"

namespace waywright::dxf {
namespace {

constexpr double largest_number = 1e12;  // drawing units: a kilometre in micrometres is 1e9
constexpr double least_bulge = 1e-9;     // under it an arc rises half a micrometre over a kilometre
constexpr double largest_angle = 1e6;    // GDAL turns angles back one turn at a time
constexpr double angle_digits = 1e-4;    // rad: a whole turn written with five digits or more may be so much more than one
constexpr double rounding = 1e-9;        // rad

constexpr std::array<std::string_view, 9> outlines{"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "SOLID", "TRACE"};

/// Counter-clockwise from one angle to the other, rad in (0, 2π]; exactly 2π where a whole turn is meant. Angles that are the same are one, too.
double turn_between(double from, double to, double whole) {
  if (to == from) return two_pi;
  // What rises through a turn and a little more is a turn; what falls may be a short arc across 0.
  const double turns = std::abs(to - from) / whole, over = (turns - std::round(turns)) * two_pi;
  if (turns > 0.5 && over >= -rounding && over <= (to > from ? angle_digits : rounding)) return two_pi;
  const double sweep = std::fmod(to - from, whole);
  return (sweep > 0.0 ? sweep : sweep + whole) * (two_pi / whole);
}

bool is_angle(std::string_view type, int code) {
  return ((type == "ARC" || type == "INSERT") && (code == 50 || code == 51)) || (type == "ELLIPSE" && (code == 41 || code == 42));
}

struct Corner {
  Vec2 at{};
  double bulge = 0.0;
  bool frame = false;  // a control point of a smoothed polyline, which is not on it
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
    if (group.code == 70 && !light) corners.back().frame = (static_cast<int>(std::clamp(number_from(group.value).value_or(0.0), 0.0, 65535.0)) & 16) != 0;
  }
  std::erase_if(corners, [](const Corner& c) { return c.frame; });
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
    constexpr int in_space = 8;  // of its vertices only the places count
    if (entity.type == "POLYLINE" && (whole_number(entity, 70, 0) & in_space) != 0) return false;
    const auto corners = corners_of(entity);
    return std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return std::abs(c.bulge) >= least_bulge; });
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

Chain curve_of(const Item& entity) {
  const Vec2 at{number(entity, 10, 0.0), number(entity, 20, 0.0)};
  if (entity.type == "CIRCLE" || entity.type == "ARC") {
    const double radius = std::abs(number(entity, 40, 0.0)), from = number(entity, 50, 0.0);
    if (entity.type == "CIRCLE") return elliptic_arc(at, {radius, 0.0}, {0.0, radius}, 0.0, two_pi);
    return elliptic_arc(at, {radius, 0.0}, {0.0, radius}, from * pi / 180.0, turn_between(from, number(entity, 51, 0.0), 360.0));
  }
  if (entity.type == "ELLIPSE") {
    // Its points are those of the world. The normal says on which side of the major axis the minor one lies.
    const Vec2 major{number(entity, 11, 1.0), number(entity, 21, 0.0)};
    const double height = number(entity, 31, 0.0), ratio = number(entity, 40, 1.0);
    Vec2 normal{number(entity, 210, 0.0), number(entity, 220, 0.0)};
    double up = number(entity, 230, 1.0);
    const double length = std::hypot(normal.x, normal.y, up);
    if (length > 0.0) normal = (1.0 / length) * normal, up /= length;
    else up = 1.0;
    const Vec2 minor = ratio * (up * left_of(major) - height * left_of(normal));
    const double from = number(entity, 41, 0.0);
    return elliptic_arc(at, major, minor, from, turn_between(from, number(entity, 42, two_pi), two_pi));
  }
  const bool closed = (whole_number(entity, 70, 0) & 1) != 0;
  const auto corners = corners_of(entity);
  Chain chain;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (chain.empty()) chain.push_back({corners[i].at});
    if (i + 1 == corners.size() && !closed) break;
    const double bulge = std::abs(corners[i].bulge) < least_bulge ? 0.0 : corners[i].bulge;
    add_arc(chain, corners[(i + 1) % corners.size()].at, bulge);
  }
  return chain;
}

SplineCurve spline_of(const Item& entity) {
  return {whole_number(entity, 71, 3), numbers_of(entity, 40), points_of(entity, 10), numbers_of(entity, 41)};
}

std::vector<Vec2> fit_points_of(const Item& entity) { return points_of(entity, 11); }

}  // namespace waywright::dxf
