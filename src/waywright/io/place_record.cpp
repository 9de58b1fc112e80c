#include "waywright/io/place_record.hpp"

#include <cmath>
#include <limits>

#include "waywright/io/files.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

constexpr double most = std::numeric_limits<double>::max();

Json spot_to_json(const std::optional<TightSpot>& spot) {
  if (!spot) return nullptr;
  return {{"clearance", spot->clearance}, {"point", to_json(spot->point)}, {"obstacle", spot->against}};
}

Json figures_to_json(const PlaceFigures& f) {
  Json j{{"name", f.name}, {"status", to_string(f.status)}};
  j["reason"] = f.reason.empty() ? Json(nullptr) : Json(f.reason);
  j["reproducible"] = f.reproducible;
  j["planner"] = f.planner;
  j["clearance_asked"] = f.asked;
  j["plan_seconds"] = f.plan_seconds;
  j["figures"] = nullptr;
  if (!f.has_path) return j;
  j["figures"] = {{"collision_free", f.collision_free}, {"tightest", spot_to_json(f.tightest)}, {"on_the_way", spot_to_json(f.on_the_way)},
                  {"length", f.length},                 {"max_curvature", std::min(f.max_curvature, most)}};
  if (f.pocket_clearance) j["figures"]["pocket_clearance"] = *f.pocket_clearance;
  j["figures"]["curvature_limit"] = f.curvature_limit ? Json(*f.curvature_limit) : Json(nullptr);
  j["figures"]["direction_changes"] = f.direction_changes;
  j["figures"]["travel_time"] = f.travel_time;
  return j;
}

std::optional<TightSpot> read_spot(const Node& node, const char* field) {
  if (!node.given(field)) return std::nullopt;
  const Node spot = node.at(field);
  return TightSpot{spot.at("clearance").number(0.0, most), spot.at("point").point(most), spot.at("obstacle").text()};
}

PlaceFigures read_figures(const Node& node) {
  PlaceFigures f;
  f.name = node.at("name").text();
  f.status = status_from_string(node.at("status").text()).value_or(Status::no_path);
  if (node.given("reason")) f.reason = node.at("reason").text();
  f.reproducible = node.at("reproducible").boolean();
  f.planner = node.at("planner").text();
  f.asked = node.at("clearance_asked").number(0.0, most);
  f.plan_seconds = node.at("plan_seconds").number(0.0, most);
  f.has_path = node.given("figures");
  if (!f.has_path) return f;
  const Node figures = node.at("figures");
  f.collision_free = figures.at("collision_free").boolean();
  f.tightest = read_spot(figures, "tightest");
  if (figures.has("pocket_clearance")) f.pocket_clearance = figures.at("pocket_clearance").number(0.0, most);
  f.on_the_way = read_spot(figures, "on_the_way");
  f.length = figures.at("length").number(0.0, most);
  f.max_curvature = figures.at("max_curvature").number(0.0, most);
  if (figures.given("curvature_limit")) f.curvature_limit = figures.at("curvature_limit").number(0.0, most);
  f.direction_changes = static_cast<int>(figures.at("direction_changes").integer(0, 1'000'000));
  f.travel_time = figures.at("travel_time").number(0.0, most);
  return f;
}

}  // namespace

std::string place_record_json(const PlaceRecord& record) {
  Json j{{"format", "waywright-place/1"}, {"key", record.key}, {"files", Json::object()}, {"place", figures_to_json(record.figures)}};
  j["place"]["picture"] = {record.figures.picture_width, record.figures.picture_height};
  for (const auto& [name, hash] : record.files) j["files"][name] = hash;
  j["sha256"] = sha256(pretty(j));
  return pretty(j);
}

std::optional<PlaceRecord> parse_place_record(const std::string& text) {
  auto json = parse_json(text, "");
  if (!json || !json->is_object() || !json->contains("sha256")) return std::nullopt;
  const Json seal = (*json)["sha256"];
  json->erase("sha256");
  if (!seal.is_string() || seal.get<std::string>() != sha256(pretty(*json))) return std::nullopt;
  ReadContext context{"", {}};
  const Node node{*json, "", context};
  check_format(node, "place");
  if (node.failed()) return std::nullopt;
  PlaceRecord record;
  record.key = node.at("key").text();
  for (const auto& [name, hash] : node.at("files").members("hashes by name")) record.files[name] = hash.text();
  record.figures = read_figures(node.at("place"));
  const Vec2 picture = node.at("place").at("picture").point(1e4);
  record.figures.picture_width = picture.x;
  record.figures.picture_height = picture.y;
  if (context.error) return std::nullopt;
  return record;
}

std::string check_json(const std::vector<PlaceFigures>& rows, const std::vector<std::string>& folders, const CheckCounts& counts,
                       const std::string& version) {
  Json j{{"format", "waywright-check/1"}, {"version", version},          {"places", counts.places},         {"solved", counts.solved},
         {"not_solved", counts.not_solved}, {"planned", counts.planned}, {"taken_over", counts.taken_over}, {"not_reached", counts.not_reached}};
  Json list = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Json row = figures_to_json(rows[i]);
    row["folder"] = folders[i];
    list.push_back(std::move(row));
  }
  j["rows"] = std::move(list);
  return pretty(j);
}

}  // namespace waywright
