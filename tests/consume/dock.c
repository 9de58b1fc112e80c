/* The C header, compiled as C and linked against what is installed. */
#include <stdio.h>
#include <waywright/docking/docking.h>

int main(void) {
  const ww_point outline[] = {{-2.3, -0.45}, {0.4, -0.45}, {0.4, 0.45}, {-2.3, 0.45}};
  const ww_point area[] = {{0, 0}, {12, 0}, {12, 14}, {0, 14}};
  ww_request request = {0};
  request.vehicle.footprint.first = outline;
  request.vehicle.footprint.count = 4;
  request.vehicle.wheelbase = 1.9;
  request.vehicle.max_steering = 1.05;
  request.vehicle.speed = request.vehicle.reverse_speed = 1.0;
  request.vehicle.acceleration = request.vehicle.deceleration = 0.5;
  request.station.area.first = area;
  request.station.area.count = 4;
  request.station.shelf_center.x = 0.9;
  request.station.shelf_center.y = 7.0;
  request.station.shelf_depth = 1.2;
  request.station.shelf_width = 2.7;
  request.station.gap = 0.1;
  request.start.x = 9.5;
  request.start.y = 7.0;
  request.clearance = 0.05;
  char message[200];
  ww_docking* docking = ww_docking_prepare(&request, message, sizeof message);
  if (docking == NULL) return puts(message), 2;
  ww_plan* plan = ww_docking_plan(docking, 0.0, NULL);
  const int solved = ww_plan_status(plan) == WW_SOLVED;
  printf("%.3f m %s\n", ww_plan_length(plan), ww_plan_reason(plan));
  ww_plan_free(plan);
  ww_docking_free(docking);
  return solved ? 0 : 1;
}
