#include "waywright/io/lane_courses.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace waywright {
namespace {

using Json = nlohmann::json;

std::optional<Vec2> point_from(const Json& j) {
  if (!j.is_array() || j.size() != 2 || !j[0].is_number() || !j[1].is_number()) return std::nullopt;
  const Vec2 p{j[0].get<double>(), j[1].get<double>()};
  constexpr double farthest = 1e7;  // m
  return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest ? std::optional{p} : std::nullopt;
}

}  // namespace

LaneCourses lane_courses_of(const std::string& meta) {
  LaneCourses lanes;
  if (meta.find("\"courses\"") == std::string::npos) return lanes;
  const Json all = Json::parse(meta, nullptr, false);
  if (!all.is_object() || !all.contains("lanes") || !all["lanes"].is_object()) return lanes;
  const Json& told = all["lanes"];
  if (told.contains("width") && told["width"].is_number()) lanes.width = told["width"].get<double>();
  if (!told.contains("courses") || !told["courses"].is_array()) return lanes;
  const bool has_ways = told.contains("one_way") && told["one_way"].is_array();
  for (std::size_t i = 0; i < told["courses"].size(); ++i) {
    const Json& course = told["courses"][i];
    Polyline points;
    for (std::size_t k = 0; course.is_array() && k < course.size(); ++k) {
      if (const auto p = point_from(course[k])) points.push_back(*p);
    }
    if (points.size() < 2) continue;
    lanes.courses.push_back(std::move(points));
    lanes.one_way.push_back(has_ways && i < told["one_way"].size() && told["one_way"][i].is_boolean() && told["one_way"][i].get<bool>() ? 1 : 0);
  }
  return lanes;
}

}  // namespace waywright
