// The C interface over the C++ one.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "waywright/docking/docking.h"
#include "waywright/docking/docking.hpp"

struct ww_docking {
  waywright::Docking docking;
};

struct ww_cancel {
  std::atomic<bool> raised{false};
};

struct ww_plan {
  waywright::DockingPlan plan;
  std::string reason;
  std::vector<ww_sample> samples;
};

struct ww_session {
  waywright::DockingSession session;
  ww_plan plan;
};

namespace {

using namespace waywright;

std::vector<Vec2> list_of(const ww_points& points) {
  std::vector<Vec2> list;
  for (size_t i = 0; i < points.count; ++i) list.push_back({points.first[i].x, points.first[i].y});
  return list;
}

std::vector<std::vector<Vec2>> lists_of(const ww_polygons& polygons) {
  std::vector<std::vector<Vec2>> lists;
  for (size_t i = 0; i < polygons.count; ++i) lists.push_back(list_of(polygons.first[i]));
  return lists;
}

std::optional<double> limit_of(double value) { return value == 0.0 ? std::nullopt : std::optional{value}; }

Vehicle vehicle_of(const ww_vehicle& v) {
  Vehicle vehicle;
  vehicle.footprint.polygon = list_of(v.footprint);
  vehicle.forks = lists_of(v.forks);
  if (v.wheelbase == 0.0) {
    vehicle.drive = Differential{1.0};  // the track plays no part in docking
  } else {
    vehicle.drive = Tricycle{v.wheelbase, v.max_steering, limit_of(v.max_steering_rate), v.front_steered != 0 ? SteeredAxle::front : SteeredAxle::rear};
  }
  Limits& limits = vehicle.limits;
  limits.speed = v.speed;
  limits.reverse_speed = v.reverse_speed;
  limits.acceleration = v.acceleration;
  limits.deceleration = v.deceleration;
  limits.lateral_acceleration = limit_of(v.lateral_acceleration);
  limits.angular_speed = limit_of(v.angular_speed);
  limits.curvature = limit_of(v.curvature);
  limits.curvature_rate = limit_of(v.curvature_rate);
  return vehicle;
}

Scenario scenario_of(const ww_request& r) {
  Scenario scenario;
  scenario.vehicle = vehicle_of(r.vehicle);
  scenario.start = {r.start.x, r.start.y, r.start.heading};
  scenario.start_motion = {r.start_speed, r.start_curvature};
  scenario.clearance = r.clearance;
  scenario.pose_error = {r.lateral_error, r.longitudinal_error, r.heading_error};
  scenario.map.obstacles = lists_of(r.station.obstacles);
  scenario.map.lines = lists_of(r.station.lines);
  scenario.map.points = list_of(r.station.points);
  Station station;
  station.area = list_of(r.station.area);
  Shelf& shelf = station.shelf;
  shelf.center = {r.station.shelf_center.x, r.station.shelf_center.y};
  shelf.heading = r.station.shelf_heading;
  shelf.depth = r.station.shelf_depth;
  shelf.width = r.station.shelf_width;
  shelf.gap = r.station.gap;
  shelf.slot = r.station.slot;
  if (r.station.insertion_depth != 0.0) {
    Insertion insertion;
    insertion.depth = r.station.insertion_depth;
    for (size_t i = 0; i < r.station.pocket_count; ++i) insertion.pockets.push_back({r.station.pockets[i][0], r.station.pockets[i][1]});
    station.insertion = std::move(insertion);
  }
  scenario.mission = std::move(station);
  return scenario;
}

void say(char* message, size_t size, const std::string& text) {
  if (message == nullptr || size == 0) return;
  const size_t length = std::min(size - 1, text.size());
  std::memcpy(message, text.data(), length);
  message[length] = '\0';
}

ww_status status_of(Status status) {
  switch (status) {
    case Status::solved: return WW_SOLVED;
    case Status::unproven: return WW_UNPROVEN;
    case Status::no_path: return WW_NO_PATH;
    case Status::start_in_collision: return WW_START_IN_COLLISION;
    case Status::goal_in_collision: return WW_GOAL_IN_COLLISION;
    case Status::start_outside: return WW_START_OUTSIDE;
    case Status::goal_outside: return WW_GOAL_OUTSIDE;
    case Status::timed_out: return WW_TIMED_OUT;
    case Status::canceled: return WW_CANCELED;
  }
  return WW_BAD_INPUT;
}

BudgetLimits limits_of(double seconds) {
  BudgetLimits limits;
  if (std::isfinite(seconds) && seconds > 0.0) limits.seconds = seconds;
  return limits;
}

const std::atomic<bool>* flag_of(const ww_cancel* cancel) { return cancel == nullptr ? nullptr : &cancel->raised; }

/// The session's plan as C has it.
const ww_plan* keep(ww_session& session, const DockingPlan& plan) {
  ww_plan& kept = session.plan;
  try {
    kept.plan = plan;
    kept.samples.clear();
    for (const Sample& s : plan.samples) kept.samples.push_back({s.s, s.x, s.y, s.heading, s.curvature, s.t, s.speed, s.direction});
    kept.reason = plan.status == Status::solved ? std::string{} : session.session.reason();
  } catch (const std::exception&) {
    return nullptr;
  }
  return &kept;
}

}  // namespace

ww_docking* ww_docking_prepare(const ww_request* request, char* message, size_t size) {
  try {
    if (request == nullptr) {
      say(message, size, "there is no request");
      return nullptr;
    }
    PatternDockingOptions options;
    if (request->evaluations != 0) options.evaluations = request->evaluations;
    if (options.evaluations < 1 || options.evaluations > 10'000'000) {
      say(message, size, "evaluations: out of range (allowed: 0 to 10000000)");
      return nullptr;
    }
    auto docking = Docking::prepare(scenario_of(*request), options);
    if (docking) return new (std::nothrow) ww_docking{std::move(*docking)};
    say(message, size, docking.error().message());
  } catch (const std::exception&) {
    say(message, size, "there is not enough memory for this station");
  }
  return nullptr;
}

void ww_docking_free(ww_docking* docking) { delete docking; }

ww_cancel* ww_cancel_create() { return new (std::nothrow) ww_cancel; }
void ww_cancel_raise(ww_cancel* cancel) {
  if (cancel != nullptr) cancel->raised.store(true, std::memory_order_relaxed);
}
void ww_cancel_free(ww_cancel* cancel) { delete cancel; }

ww_docking* ww_docking_from(const ww_docking* docking, const ww_state* now, const ww_pose* shelf, char* message, size_t size) {
  try {
    if (docking == nullptr || now == nullptr) {
      say(message, size, "there is no docking or no state");
      return nullptr;
    }
    std::optional<Shelf> measured;
    if (shelf != nullptr) {
      measured = std::get<Station>(docking->docking.problem().scenario().mission).shelf;
      measured->center = {shelf->x, shelf->y};
      measured->heading = shelf->heading;
    }
    auto again = docking->docking.from({now->pose.x, now->pose.y, now->pose.heading}, {now->speed, now->curvature}, measured);
    if (again) return new (std::nothrow) ww_docking{std::move(*again)};
    say(message, size, again.error().message());
  } catch (const std::exception&) {
    say(message, size, "there is not enough memory for this station");
  }
  return nullptr;
}

ww_session* ww_session_create(const ww_docking* docking) {
  if (docking == nullptr) return nullptr;
  try {
    auto session = DockingSession::on(docking->docking);
    if (!session) return nullptr;
    auto made = std::make_unique<ww_session>(ww_session{std::move(*session), {}});
    made->plan.samples.reserve(DockingSession::usual_samples);
    made->plan.plan.samples.reserve(DockingSession::usual_samples);
    return made.release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

void ww_session_free(ww_session* session) { delete session; }

const ww_plan* ww_session_plan(ww_session* session, double seconds, const ww_cancel* cancel) {
  return session == nullptr ? nullptr : keep(*session, session->session.plan(limits_of(seconds), flag_of(cancel)));
}

const ww_plan* ww_session_replan(ww_session* session, const ww_plan* old, double driven, double seconds, const ww_cancel* cancel) {
  if (session == nullptr) return nullptr;
  if (old == nullptr) return ww_session_plan(session, seconds, cancel);
  return keep(*session, session->session.replan(old->plan, driven, limits_of(seconds), flag_of(cancel)));
}

ww_plan* ww_docking_plan(const ww_docking* docking, double seconds, const ww_cancel* cancel) {
  ww_session* session = ww_session_create(docking);
  if (session == nullptr) return nullptr;
  ww_plan* plan = nullptr;
  try {
    ww_session_plan(session, seconds, cancel);
    plan = new ww_plan{std::move(session->plan)};
  } catch (const std::exception&) {
  }
  ww_session_free(session);
  return plan;
}

void ww_plan_free(ww_plan* plan) { delete plan; }

ww_status ww_plan_status(const ww_plan* plan) { return plan == nullptr ? WW_NO_PATH : status_of(plan->plan.status); }
const char* ww_plan_reason(const ww_plan* plan) { return plan == nullptr ? "" : plan->reason.c_str(); }
double ww_plan_clearance(const ww_plan* plan) { return plan == nullptr ? 0.0 : plan->plan.certificate.clearance; }
double ww_plan_length(const ww_plan* plan) { return plan == nullptr ? 0.0 : plan->plan.length; }
double ww_plan_time(const ww_plan* plan) { return plan == nullptr ? 0.0 : plan->plan.travel_time; }
double ww_plan_cost(const ww_plan* plan) { return plan == nullptr ? 0.0 : plan->plan.cost; }
int ww_plan_is_carried_on(const ww_plan* plan) { return plan != nullptr && plan->plan.is_carried_on ? 1 : 0; }
double ww_plan_moved(const ww_plan* plan) { return plan == nullptr ? 0.0 : plan->plan.moved; }
ww_state ww_plan_state(const ww_plan* plan, double time) {
  if (plan == nullptr || plan->plan.samples.empty()) return {};
  try {
    const Handover h = handover_at(plan->plan.path, plan->plan.samples, time);
    return {h.driven, {h.pose.x, h.pose.y, h.pose.heading}, h.motion.speed, h.motion.curvature};
  } catch (const std::exception&) {
    return {};
  }
}
const ww_sample* ww_plan_samples(const ww_plan* plan, size_t* count) {
  if (count != nullptr) *count = plan == nullptr ? 0 : plan->samples.size();
  return plan == nullptr ? nullptr : plan->samples.data();
}
