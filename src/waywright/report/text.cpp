// The short table that `plan` and `import` print.
#include <fmt/format.h>

#include <cmath>

#include "waywright/report/report.hpp"
#include "waywright/report/spots.hpp"
#include "waywright/report/words.hpp"

namespace waywright {

std::string plan_text(const Plan& plan) {
  std::string out;
  const auto row = [&](const char* name, const std::string& value) {
    out += fmt::format("  {:<22} {}\n", name, value);
  };
  out += fmt::format("{}: {}\n", plan.scenario.name.empty() ? "plan" : plan.scenario.name,
                     to_string(plan.status));
  if (!plan.reason.empty()) out += "  " + reason_once(plan, false) + "\n";
  if (plan.legs.empty()) row("planner", plan.planner);
  if (!plan.samples.empty()) {
    const Metrics& m = plan.metrics;
    const Certificate& c = plan.certificate;
    const double limit = plan.scenario.vehicle.max_curvature();
    row("length", fmt::format("{:.3f} m", m.length));
    // What is proven of a path that is not: its clearance may hold and still be too little, or its curvature
    // too much.
    if (plan.status == Status::solved)
      row("proven clearance", clearance_words(c));
    else
      row("clearance", c.collision_free ? fmt::format("{}, {:g} m asked for; the path is not proven",
                                                      clearance_words(c), plan.scenario.clearance)
                            : plan.status == Status::canceled ? "not proven: the run was interrupted"
                                        : "none: it touches or may touch");
    row("greatest curvature", std::isfinite(limit)
                                  ? fmt::format("{:.4f} 1/m (limit {:.4f})", m.max_curvature, limit)
                                  : fmt::format("{:.4f} 1/m", m.max_curvature));
    row("change of curvature", fmt::format("{:.4f} 1/m", m.curvature_change));
    row("direction changes", fmt::format("{}", m.direction_changes));
    if (const std::size_t stops = steering_stops(plan).size(); stops > 0)
      row("stops at curv. jumps", fmt::format("{}", stops));
    row("travel time", fmt::format("{:.2f} s", m.travel_time));
  }
  for (std::size_t i = 0; i < plan.legs.size(); ++i) {
    const LegResult& leg = plan.legs[i];
    std::string text = to_string(leg.status);
    if (leg.has_path) {
      text = fmt::format("{:9.3f} m {:7.1f} s, {} clear", leg.metrics.length, leg.metrics.travel_time, leg.certificate.collision_free ? clearance_words(leg.certificate) : "not");
      if (leg.status != Status::solved) text += fmt::format(", {}", to_string(leg.status));
    }
    row(fmt::format("leg {}", i + 1).c_str(), fmt::format("{}{}{}", text, leg.load.empty() ? "" : ", with " + leg.load, leg.name.empty() ? "" : ": " + leg.name));
  }
  row("effort", effort_words(plan.effort));
  row("time",
      fmt::format("plan {:.1f} ms, prove {:.1f} ms", 1000.0 * plan.timing.plan, 1000.0 * plan.timing.prove));
  for (const std::string& sentence : explanation_once(plan, false)) out += "  - " + sentence + "\n";
  return out;
}

}  // namespace waywright
