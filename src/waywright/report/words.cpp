#include "waywright/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/metrics/metrics.hpp"

namespace waywright {
namespace {

constexpr double least_worry = 0.01;  // m of residual: the accuracy of points read off a map

/// Without a full stop at its end.
std::string_view core_of(std::string_view sentence) {
  while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.remove_suffix(1);
  return sentence;
}

bool says(std::string_view text, std::string_view sentence) {
  return !core_of(sentence).empty() && text.find(core_of(sentence)) != std::string_view::npos;
}

}  // namespace

std::string headline(const Plan& plan) {
  switch (plan.status) {
    case Status::solved: {
      const PoseError& e = plan.scenario.pose_error;
      const bool error = e.lateral + e.longitudinal + e.heading > 0.0;
      if (is_beyond_measure(plan.certificate))
        return "Solved and proven: " + clearance_words(plan.certificate) + " of clearance";
      return fmt::format("Solved and proven: at least {:.1f} mm of clearance{}",
                         1000.0 * plan.certificate.clearance,
                         (plan.scenario.moving.empty() ? std::string{} : fmt::format(" to what stands, {:.1f} mm to what moves as predicted", 1000.0 * plan.scenario.clearance)) +
                             (error ? " at every pose within the pose error" : ""));
    }
    case Status::unproven:
      return "A path, but not proven";
    case Status::no_path:
      return "No path";
    case Status::start_in_collision:
      return "The start is in collision";
    case Status::goal_in_collision:
      return "The goal is in collision";
    case Status::start_outside:
      return "The start is outside";
    case Status::goal_outside:
      return "The goal is outside";
    case Status::timed_out:
      return "Out of time, no path yet";
    case Status::canceled:
      return plan.path.pieces.empty() ? "Interrupted, no path yet" : "Interrupted: a path, not proven";
  }
  return to_string(plan.status);
}

std::string as_sentence(std::string text, std::string_view planner) {
  if (text.empty()) return text;
  const bool is_name = !planner.empty() && text.starts_with(planner);
  if (!is_name && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  if (text.back() != '.') text += '.';
  return text;
}

bool is_beyond_measure(const Certificate& c) {
  return c.collision_free && (!c.tightest || c.clearance >= clearance_cap - 2.0 * c.tolerance);
}

std::string clearance_words(const Certificate& c) {
  if (!is_beyond_measure(c)) return fmt::format("{:.4f} m", c.clearance);
  // The proof's own tolerance is not worth a decimal here.
  return fmt::format("more than {:g} m", std::floor(10.0 * (c.clearance + c.tolerance) + 1e-9) / 10.0);
}

std::string residual_words(const Alignment& alignment) {
  std::string text;
  for (const double r : alignment.residuals) text += (text.empty() ? "" : ", ") + fmt::format("{:.3f}", r);
  return text.empty() ? text : text + " m";
}

std::optional<std::string> alignment_warning(const Scenario& scenario) {
  if (!scenario.map.alignment || scenario.map.alignment->residuals.empty()) return std::nullopt;
  const std::vector<double>& residuals = scenario.map.alignment->residuals;
  const auto worst = std::max_element(residuals.begin(), residuals.end());
  if (*worst <= std::max(scenario.clearance, least_worry)) return std::nullopt;
  return fmt::format(
      "The map is {:.3f} m off at pair {} of the points that it was aligned by, more than the clearance of "
      "{:g} m: what is proven holds for "
      "the map as placed, which may not be where it truly is.",
      *worst, worst - residuals.begin(), scenario.clearance);
}

std::vector<std::string> warnings(const Plan& plan) {
  std::vector<std::string> all;
  if (plan.status == Status::canceled) {
    all.emplace_back(plan.path.pieces.empty() ? "The run was interrupted before there was a path." : "The run was interrupted before its path was proven.");
  } else if (!plan.reproducible) {
    all.push_back(
        fmt::format("The work was cut short by {}: another run may give another {}.",
                    plan.scenario.budget.seconds ? "the budget's seconds or an interrupt" : "an interrupt",
                    plan.samples.empty() ? "answer" : "path, and a better one"));
  }
  if (auto alignment = alignment_warning(plan.scenario)) all.push_back(std::move(*alignment));
  return all;
}

std::string reason_once(const Plan& plan, bool beside_alternatives) {
  for (const Alternative& a : beside_alternatives ? plan.alternatives : std::vector<Alternative>{}) {
    // "…; the second choice found none either: WHY" ends before the why that stands in the table.
    const std::size_t at = core_of(a.outcome).empty() ? std::string::npos : plan.reason.find(core_of(a.outcome));
    if (at == std::string::npos || at < 2 || plan.reason.compare(at - 2, 2, ": ") != 0) continue;
    return as_sentence(plan.reason.substr(0, at - 2), plan.planner);
  }
  std::size_t first = std::string::npos;
  for (const std::string& sentence : plan.explanation) {
    if (says(sentence, plan.reason)) continue;
    if (!says(plan.reason, sentence)) return as_sentence(plan.reason, plan.planner);
    first = std::min(first, plan.reason.find(core_of(sentence)));
  }
  if (first == std::string::npos || first == 0) return as_sentence(plan.reason, plan.planner);
  return as_sentence(std::string{core_of(std::string_view{plan.reason}.substr(0, first))}, plan.planner);
}

std::vector<std::string> explanation_once(const Plan& plan, bool beside_alternatives) {
  std::vector<std::string> kept;
  for (const std::string& sentence : plan.explanation) {
    const bool told =
        beside_alternatives && std::any_of(plan.alternatives.begin(), plan.alternatives.end(),
                                           [&](const Alternative& a) { return says(a.outcome, sentence); });
    if (!told && !says(sentence, plan.reason)) kept.push_back(sentence);
  }
  return kept;
}

std::string effort_words(const Effort& effort) {
  std::string text = fmt::format("{} evaluation{}", effort.evaluations, effort.evaluations == 1 ? "" : "s");
  if (effort.expansions > 0) text += fmt::format(", {} expansions", effort.expansions);
  return text;
}

}  // namespace waywright
