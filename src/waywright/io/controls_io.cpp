#include "waywright/io/controls_io.hpp"

#include <array>
#include <charconv>

#include "waywright/core/version.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

/// The columns of a series, in order.
struct Column {
  std::string name;
  std::vector<double> values;
};
std::vector<Column> columns_of(const Vehicle& vehicle, std::span<const ControlRow> rows, const WheelTorques* torques) {
  std::vector<Column> columns;
  const auto add = [&](const char* name, const auto& value) {
    Column column{name, {}};
    for (const ControlRow& row : rows) column.values.push_back(value(row));
    columns.push_back(std::move(column));
  };
  add("t", [](const ControlRow& r) { return r.t; });
  add("v", [](const ControlRow& r) { return r.twist.forward; });
  if (std::holds_alternative<Mecanum>(vehicle.drive)) add("v_left", [](const ControlRow& r) { return r.twist.left; });
  add("w", [](const ControlRow& r) { return r.twist.turn; });
  const std::vector<WheelColumn> wheels = wheel_columns(vehicle.drive);
  for (std::size_t k = 0; k < wheels.size(); ++k) add(wheels[k].name, [&](const ControlRow& r) { return wheel_values(vehicle.drive, r)[k]; });
  if (torques != nullptr) {
    for (const auto& [name, torque] : torque_columns) {
      Column column{name, {}};
      for (const MecanumTorques& each : torques->rows) column.values.push_back(each.*torque);
      columns.push_back(std::move(column));
    }
  }
  add("x", [](const ControlRow& r) { return r.pose.x; });
  add("y", [](const ControlRow& r) { return r.pose.y; });
  add("heading", [](const ControlRow& r) { return r.pose.heading; });
  return columns;
}

Json error_to_json(const EndError& error) { return {{"position", error.position}, {"heading", error.heading}}; }

Json head(const Plan& plan, const char* method, double period) {
  const Vehicle& vehicle = plan.scenario.vehicle;
  Json j{{"format", "waywright-controls/1"}, {"version", version}, {"method", method}, {"period", period}};
  j["plan"] = {{"scenario", plan.scenario.name}, {"planner", plan.planner}, {"seed", plan.seed}, {"travel_time", plan.samples.back().t}};
  j["vehicle"] = {{"name", vehicle.name}, {"drive", vehicle_to_json(vehicle)["drive"]}};
  return j;
}

Json series_to_json(const Vehicle& vehicle, std::span<const ControlRow> rows, const WheelTorques* torques = nullptr) {
  Json series = Json::object();
  for (Column& column : columns_of(vehicle, rows, torques)) series[column.name] = std::move(column.values);
  return series;
}

}  // namespace

std::string controls_json(const Plan& plan, const ExactControls& controls, const WheelTorques* torques, double slowing) {
  Json j = head(plan, "exact", controls.period);
  j["time"] = controls.rows.back().t;
  j["end_error"] = error_to_json(controls.end);
  j["figures"] = {{"commands", controls.rows.size() - 1},
                  {"stands", controls.stands},
                  {"greatest_deviation", controls.deviation},
                  {"midpoint_odometry_end_error", error_to_json(controls.midpoint_end)}};
  if (torques != nullptr) {
    const WheelMotors& m = torques->motors;
    j["motors"] = {{"inertia", m.inertia},
                   {"wheel_inertia", m.wheel_inertia},
                   {"rolling_arm", m.rolling_arm},
                   {"max_torque", m.most_torque > 0.0 ? Json(m.most_torque) : Json(nullptr)},
                   {"max_wheel_speed", m.most_speed > 0.0 ? Json(m.most_speed) : Json(nullptr)},
                   {"slowing", slowing},
                   {"greatest_torque", torques->greatest_torque},
                   {"greatest_wheel_speed", torques->greatest_speed},
                   {"driving", torques->driving},
                   {"braking", torques->braking},
                   {"rolling_losses", torques->rolling_losses},
                   {"kinetic_change", torques->kinetic_change}};
  }
  j["series"] = series_to_json(plan.scenario.vehicle, controls.rows, torques);
  return pretty(j);
}

std::string controls_json(const Plan& plan, const WhaleControls& controls, const Parameters& parameters, std::uint64_t seed) {
  Json j = head(plan, "woa", controls.period);
  j["seed"] = seed;
  j["parameters"] = parameters_to_json(parameters);
  j["time"] = controls.rows.back().t;
  j["end_error"] = error_to_json(controls.end);
  j["collision_free"] = controls.collision_free;
  j["arrives"] = controls.arrives;
  std::int64_t triplets = 0;
  for (const ControlSegment& segment : controls.segments) triplets += static_cast<std::int64_t>(segment.triplets.size());
  j["figures"] = {{"segments", controls.segments.size()},
                  {"triplets", triplets},
                  {"greatest_segment_end_error", controls.worst_end},
                  {"least_clearance", controls.least_clearance},
                  {"evaluations", controls.evaluations}};
  Json segments = Json::array();
  for (const ControlSegment& segment : controls.segments) {
    Json list = Json::array();
    for (const Triplet& triplet : segment.triplets) list.push_back({triplet.v, triplet.turn, triplet.time});
    segments.push_back({{"to", to_json(segment.to.pose)},
                        {"direction", segment.to.direction},
                        {"stands", segment.to.is_stand},
                        {"triplets", std::move(list)},
                        {"time", segment.time},
                        {"end_error", error_to_json(segment.end)},
                        {"searches", segment.searches},
                        {"evaluations", segment.evaluations},
                        {"collision_free", segment.collision_free}});
  }
  j["segments"] = std::move(segments);
  j["series"] = series_to_json(plan.scenario.vehicle, controls.rows);
  return pretty(j);
}

std::string controls_csv(const Vehicle& vehicle, std::span<const ControlRow> rows, const WheelTorques* torques) {
  const std::vector<Column> columns = columns_of(vehicle, rows, torques);
  std::string out;
  for (std::size_t k = 0; k < columns.size(); ++k) out += (k == 0 ? "" : ",") + columns[k].name;
  out += '\n';
  std::array<char, 32> digits{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (k > 0) out += ',';
      out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), columns[k].values[i]).ptr);
    }
    out += '\n';
  }
  return out;
}

}  // namespace waywright
