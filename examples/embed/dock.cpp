// Where a vehicle's program would start: one station, planned from where the vehicle stands, within 20 ms.
//   find_package(waywright REQUIRED COMPONENTS docking)
//   target_link_libraries(app PRIVATE waywright::docking)
#include <cstdio>

#include "waywright/docking/docking.hpp"

using namespace waywright;

int main() {
  // The vehicle: outline in its own frame (x towards the fork tips, origin in the middle of the load axle), drive, limits.
  Vehicle truck;
  truck.footprint.polygon = {{-2.30, -0.45}, {0.40, -0.45}, {0.40, 0.45}, {-2.30, 0.45}};
  truck.drive = Tricycle{.wheelbase = 1.90, .max_steering = 1.05, .max_steering_rate = 0.7};
  truck.limits.speed = 1.2;
  truck.limits.curvature = 0.8;
  truck.limits.curvature_rate = 1.5;

  // The station as it was measured: the area to stay in, the shelf, what stands about, scan points.
  Station station;
  station.area = {{0, 0}, {12, 0}, {12, 14}, {0, 14}};
  station.shelf = {.center = {0.9, 7.0}, .heading = 0.0, .depth = 1.2, .width = 2.7, .gap = 0.1};

  Scenario scenario;
  scenario.vehicle = truck;
  scenario.mission = station;
  scenario.start = {9.5, 7.0, 0.0};  // forks away from the shelf
  scenario.map.obstacles = {{{6.7, 9.6}, {7.9, 9.6}, {7.9, 10.4}, {6.7, 10.4}}};
  scenario.map.points = {{4.2, 12.6}, {4.3, 12.6}, {4.4, 12.7}};
  scenario.clearance = 0.05;
  scenario.pose_error = {.lateral = 0.01, .longitudinal = 0.01, .heading = 0.005};  // what localisation and tracking may be off

  // Once for the station …
  const auto docking = Docking::prepare(scenario);
  if (!docking) {
    std::fprintf(stderr, "%s\n", docking.error().message().c_str());
    return 2;
  }
  // … and a plan whenever one is needed: the best within the deadline, proven.
  BudgetLimits deadline;
  deadline.seconds = 0.020;
  const DockingPlan plan = docking->plan(deadline);
  if (plan.status != Status::solved) {
    std::fprintf(stderr, "%s: %s\n", to_string(plan.status), plan.reason.c_str());
    return 1;
  }
  std::printf("%.2f m in %.1f s, at least %.3f m clear of everything\n", plan.length, plan.travel_time, plan.certificate.clearance);
  for (std::size_t i = 0; i < plan.samples.size(); i += 40) {
    const Sample& s = plan.samples[i];
    std::printf("  t %6.2f s  x %6.3f  y %6.3f  heading %7.4f  %s %.2f m/s\n", s.t, s.x, s.y, s.heading, s.direction < 0 ? "back" : "forth", s.speed);
  }
}
