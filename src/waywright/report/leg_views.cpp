#include "waywright/report/leg_views.hpp"

#include "waywright/judge/legs.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

/// What was tried in vain on the leg that failed, as blocked_spots wants it.
Plan failed_leg(const Plan& plan) {
  Plan leg;
  for (const Alternative& a : plan.alternatives) {
    if (!a.poses.empty()) leg.alternatives.push_back(a);
  }
  return leg;
}

}  // namespace

std::vector<LegView> leg_views(const Plan& plan, bool with_clearance) {
  std::vector<LegView> views;
  const Scenario& mission = plan.scenario;
  const auto parts = plan.samples.empty() ? std::nullopt : parts_of(plan);
  const World of_map{mission.map};
  LegBegin begin = first_leg(mission);
  for (std::size_t i = 0; i < plan.legs.size() && i < mission.legs.size(); ++i) {
    const auto problem = prepare_leg(mission, begin, of_map);
    if (!problem) return views;
    LegView& view = views.emplace_back();
    view.footprint = problem->footprint();
    if (const auto load = mission.vehicle.loads.find(begin.load); load != mission.vehicle.loads.end()) view.load = &load->second.footprint;
    view.first = problem->first_pose();
    view.last = problem->last_pose();
    view.required = problem->required_clearance();
    view.margin = problem->pose_error_margin();
    if (parts) {
      const Plan& part = (*parts)[i];
      view.samples = part.samples;
      if (with_clearance) {
        view.clearance = clearances_along(*problem, part.path, part.samples);
        view.zone_speed = zone_limits(*problem, part.samples, part.certificate.tolerance).samples;
      }
    } else {
      view.samples = plan.legs[i].driven;
      if (view.samples.empty()) view.blocked = blocked_spots(*problem, failed_leg(plan));
    }
    if (problem->free_goal() != nullptr && !view.samples.empty()) view.last = view.samples.back().pose();
    begin = next_leg(mission, begin, view.last);
    if (!view.samples.empty() && !begin.left.empty() && begin.left.back().leg == i) view.set_down = outline_of(mission, begin.left.back());
  }
  return views;
}

}  // namespace waywright
