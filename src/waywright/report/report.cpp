#include "waywright/report/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "waywright/judge/judge.hpp"
#include "waywright/report/chart.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

constexpr double picture_width = 860.0;
constexpr double chart_height = 170.0;

struct Row {
  std::string name, value, limit;
};

std::string with_limit(double value, std::optional<double> limit, const char* unit) {
  if (!limit || !std::isfinite(*limit)) return "";
  return fmt::format("limit {} {}, {:.0f} % used", fixed(*limit, 3), unit, 100.0 * value / *limit);
}

std::vector<Row> metric_rows(const Plan& plan) {
  const Metrics& m = plan.metrics;
  const Scenario& s = plan.scenario;
  std::vector<Row> rows{
      {"Proven clearance", fmt::format("{:.4f} m", plan.certificate.clearance),
       fmt::format("asked for {} m{}", fixed(s.clearance, 4),
                   s.pose_error.lateral + s.pose_error.longitudinal + s.pose_error.heading > 0.0 ? ", pose error taken off" : "")},
      {"Least clearance at samples", fmt::format("{:.4f} m", m.min_clearance), ""},
      {"Mean clearance", fmt::format("{:.3f} m", m.mean_clearance), m.mean_clearance >= clearance_cap ? "capped" : ""},
      {"Length", fmt::format("{:.3f} m", m.length), ""},
      {"Travel time", fmt::format("{:.1f} s", m.travel_time), ""},
      {"Changes of direction", fmt::format("{}", m.direction_changes), ""},
      {"Greatest curvature", fmt::format("{:.4f} 1/m", m.max_curvature), with_limit(m.max_curvature, s.vehicle.max_curvature(), "1/m")},
      {"Greatest curvature rate", fmt::format("{:.4f} 1/m²", m.max_curvature_rate),
       with_limit(m.max_curvature_rate, s.vehicle.limits.curvature_rate, "1/m²")},
      {"Change of curvature Σ|Δκ|", fmt::format("{:.3f} 1/m", m.curvature_change), ""},
      {"… as printed Σ|Δκ|/Δs", fmt::format("{:.2f} 1/m²", m.curvature_change_printed), ""},
      {"Turning", fmt::format("{:.3f} rad ({:.0f}°)", m.turning, m.turning * 180.0 / pi), ""},
      {"Collision risk", fmt::format("{:.3f} m", m.collision_risk), "∫ exp(−½(d/0.5 m)²) ds"},
  };
  return rows;
}

std::string table(const std::vector<Row>& rows) {
  std::string out = "<table>\n";
  for (const Row& r : rows) {
    out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"soft\">{}</td></tr>\n", escaped(r.name), escaped(r.value), escaped(r.limit));
  }
  return out + "</table>\n";
}

std::string charts(const Problem& problem, const Plan& plan) {
  if (plan.samples.size() < 2) return {};
  Chart curvature{"Curvature in 1/m (left positive)", {}, {}, {}, {}, true};
  Chart clearance{"Clearance in m", {}, {}, {}, {}, true};
  Chart speed{"Speed in m/s", {}, {}, {}, {}, true};
  const std::vector<double> d = clearances_along(problem, plan.path, plan.samples);
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    const Sample& s = plan.samples[i];
    for (Chart* chart : {&curvature, &clearance, &speed}) {
      chart->s.push_back(s.s);
      chart->direction.push_back(s.direction);
    }
    curvature.value.push_back(s.curvature);
    clearance.value.push_back(d[i]);
    speed.value.push_back(s.speed);
  }
  if (const double k = plan.scenario.vehicle.max_curvature(); std::isfinite(k) && k < 100.0) {
    curvature.limits = {{k, "limit"}, {-k, "limit"}};
  }
  if (problem.required_clearance() > 0.0) {
    clearance.limits = {{problem.required_clearance(), problem.pose_error_margin() > 0.0 ? "required, with pose error" : "required"}};
  }
  const Limits& limits = plan.scenario.vehicle.limits;
  speed.limits = {{limits.speed, limits.speed == limits.reverse_speed ? "limit" : "limit forwards"}};
  if (limits.speed != limits.reverse_speed) speed.limits.push_back({limits.reverse_speed, "limit backwards"});
  std::string out;
  for (const Chart* chart : {&curvature, &clearance, &speed}) out += chart_svg(*chart, picture_width, chart_height);
  return out;
}

std::string drive_words(const Vehicle& vehicle) {
  if (const auto* t = std::get_if<Tricycle>(&vehicle.drive)) {
    return fmt::format("tricycle, {} axle steered, wheelbase {} m, steering to {:.1f}°", t->steered_axle == SteeredAxle::rear ? "rear" : "front",
                       fixed(t->wheelbase, 3), t->max_steering * 180.0 / pi);
  }
  if (const auto* d = std::get_if<Differential>(&vehicle.drive)) return fmt::format("differential, track {} m", fixed(d->track, 3));
  return "mecanum";
}

std::string footprint_words(const Footprint& footprint) {
  if (footprint.is_disc()) return fmt::format("disc of radius {} m", fixed(footprint.disc, 3));
  const Box box = bounding_box(footprint.polygon);
  return fmt::format("{} corners, {} × {} m, from {} m behind to {} m before the origin", footprint.polygon.size(), fixed(box.high.x - box.low.x, 3),
                     fixed(box.high.y - box.low.y, 3), fixed(-box.low.x, 3), fixed(box.high.x, 3));
}

std::string parameter_words(const Parameters& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) {
    text += text.empty() ? "" : ", ";
    if (const auto* b = std::get_if<bool>(&value)) text += fmt::format("{} {}", name, *b ? "true" : "false");
    else if (const auto* d = std::get_if<double>(&value)) text += fmt::format("{} {}", name, *d);
    else text += fmt::format("{} {}", name, std::get<std::string>(value));
  }
  return text;
}

std::vector<Row> scenario_rows(const Problem& problem, const Plan& plan) {
  const Scenario& s = plan.scenario;
  std::vector<Row> rows{
      {"Vehicle", s.vehicle.name.empty() ? "(no name)" : s.vehicle.name, drive_words(s.vehicle)},
      {"Footprint", footprint_words(s.vehicle.footprint), ""},
      {"Start", fmt::format("({:.3f}, {:.3f}), {:.2f}°", s.start.x, s.start.y, s.start.heading * 180.0 / pi), ""},
  };
  if (const auto* station = std::get_if<Station>(&s.mission)) {
    const Pose& d = problem.goal();
    rows.push_back({"Docked pose", fmt::format("({:.3f}, {:.3f}), {:.2f}°", d.x, d.y, d.heading * 180.0 / pi),
                    fmt::format("fork tips {} m before the face, slot {} m", fixed(station->shelf.gap, 3), fixed(station->shelf.slot, 3))});
  } else {
    const Pose& g = std::get<Pose>(s.mission);
    rows.push_back({"Goal", fmt::format("({:.3f}, {:.3f}), {:.2f}°", g.x, g.y, g.heading * 180.0 / pi), ""});
  }
  if (problem.pocket()) {
    const Pose& p = problem.pocket()->inner;
    rows.push_back({"Forks in the shelf", fmt::format("({:.3f}, {:.3f}), {:.2f}°", p.x, p.y, p.heading * 180.0 / pi),
                    fmt::format("fork tips {} m behind the face", fixed(std::get<Station>(s.mission).insertion->depth, 3))});
  }
  if (!s.carried_load.empty()) {
    const double mass = s.vehicle.loads.at(s.carried_load).mass;
    rows.push_back({"Load", s.carried_load,
                    fmt::format("{} kg{}; {}", fixed(mass, 1), s.vehicle.mass > 0.0 ? fmt::format(", {} kg with the vehicle", fixed(mass + s.vehicle.mass, 1)) : "",
                                footprint_words(problem.footprint()))});
  }
  rows.push_back({"Clearance asked for", fmt::format("{} m", fixed(s.clearance, 4)), ""});
  rows.push_back({"Pose error", fmt::format("{} m lateral, {} m longitudinal, {} rad heading", fixed(s.pose_error.lateral, 4),
                                            fixed(s.pose_error.longitudinal, 4), fixed(s.pose_error.heading, 4)),
                  ""});
  rows.push_back({"Planner", plan.planner, parameter_words(plan.parameters)});
  rows.push_back({"Work", fmt::format("{} evaluations, seed {}", plan.effort.evaluations, plan.seed), plan.reproducible ? "reproducible" : "cut short by the clock"});
  std::string map = fmt::format("{} obstacles, {} lines, {} points", s.map.obstacles.size(), s.map.lines.size(), s.map.points.size());
  for (const CellGrid& g : s.map.grids) map += fmt::format(", {} ({} × {} cells of {} m)", g.name, g.columns, g.rows, fixed(g.cell, 4));
  rows.push_back({"Map", map, ""});
  if (s.map.alignment && !s.map.alignment->residuals.empty()) {
    std::string residuals;
    for (const double r : s.map.alignment->residuals) residuals += (residuals.empty() ? "" : ", ") + fmt::format("{:.3f}", r);
    rows.push_back({"Alignment residuals", residuals + " m", ""});
  }
  for (const std::string& note : s.map.notes) rows.push_back({"Repaired", note, ""});
  return rows;
}

std::string alternatives_table(const Plan& plan) {
  if (plan.alternatives.empty()) return {};
  std::string out = "<h2>What was tried</h2>\n<table><tr><th>alternative</th><th>cost</th><th>outcome</th></tr>\n";
  for (const Alternative& a : plan.alternatives) {
    out += fmt::format("<tr{}><th scope=\"row\">{}{}</th><td>{}</td><td>{}</td></tr>\n", a.chosen ? " class=\"chosen\"" : "", escaped(a.name),
                       a.chosen ? " (taken)" : "", a.cost ? fmt::format("{:.4f}", *a.cost) : "–", escaped(a.outcome));
  }
  return out + "</table>\n";
}

constexpr std::string_view page_styles = R"(
:root{color-scheme:light dark;--ink:#1b1f24;--soft:#5b6570;--paper:#fff;--line:#d8dde2;--good:#00664f;--bad:#a0001c;--tint:#f4f6f8}
@media (prefers-color-scheme:dark){:root{--ink:#e8ecf0;--soft:#a7b1bb;--paper:#14181d;--line:#343c45;--good:#4fd6ac;--bad:#ff9a9a;--tint:#1c2229}}
body{font:15px/1.5 system-ui,-apple-system,"DejaVu Sans",sans-serif;color:var(--ink);background:var(--paper);margin:0 auto;max-width:1240px;padding:20px}
h1{font-size:22px;margin:0}h2{font-size:16px;margin:26px 0 8px}.verdict{font-size:18px;font-weight:700;margin:4px 0 14px}
.good{color:var(--good)}.bad{color:var(--bad)}.soft{color:var(--soft);font-size:13px}
.columns{display:flex;flex-wrap:wrap;gap:24px;align-items:flex-start}.columns>div{flex:1 1 320px;min-width:0}.columns>.wide{flex:2 1 620px}
svg{max-width:100%;height:auto;display:block}table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:4px 8px 4px 0;border-bottom:1px solid var(--line);vertical-align:top}
th{font-weight:600}tr.chosen{background:var(--tint)}ul{padding-left:20px;margin:0}li{margin:5px 0}
@media print{body{max-width:none}.columns{display:block}}
)";

}  // namespace

std::string plan_svg(const Problem& problem, const Plan& plan) { return scene_svg(problem, plan, picture_width); }

std::string report_html(const Problem& problem, const Plan& plan) {
  const bool good = plan.status == Status::solved;
  const std::string name = plan.scenario.name.empty() ? "Plan" : plan.scenario.name;
  std::string out = fmt::format("<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">"
                                "<title>{}</title>\n<style>{}</style></head>\n<body>\n<h1>{}</h1>\n<p class=\"verdict {}\">{}</p>\n",
                                escaped(name), page_styles, escaped(name), good ? "good" : "bad", escaped(headline(plan)));
  if (!plan.reason.empty()) out += fmt::format("<p>{}</p>\n", escaped(plan.reason));
  out += "<div class=\"columns\"><div class=\"wide\">\n" + scene_svg(problem, plan, picture_width) + "</div><div>\n";
  if (!plan.explanation.empty()) {
    out += "<h2>Why this path</h2>\n<ul>\n";
    if (plan.path.pieces.empty()) out.replace(out.rfind("Why this path"), 13, "What happened");
    for (const std::string& sentence : plan.explanation) out += fmt::format("<li>{}</li>\n", escaped(sentence));
    out += "</ul>\n";
  }
  if (!plan.samples.empty()) out += "<h2>Figures</h2>\n" + table(metric_rows(plan));
  out += "</div></div>\n";
  if (const std::string along = charts(problem, plan); !along.empty()) {
    out += "<h2>Along the path</h2>\n<p class=\"soft\">Orange ground: backwards, blue ground: forwards; the dotted line is the change of direction.</p>\n" + along;
  }
  out += alternatives_table(plan);
  if (plan.certificate.checked_length > 0.0) {
    out += "<h2>What is proven</h2>\n";
    out += plan.certificate.collision_free
               ? fmt::format("<p>Along {:.3f} m of exact curves, between the samples too, no point of the footprint comes nearer than {:.4f} m to "
                             "anything on the map, at any pose within the pose error. The bound is at most {:.1f} mm under the truth. Assumed: the map shows "
                             "everything, the footprint covers the whole vehicle, and the vehicle stays within the pose error.</p>\n",
                             plan.certificate.checked_length, plan.certificate.clearance, 1000.0 * plan.certificate.tolerance)
               : "<p>No clearance could be proven for this path.</p>\n";
  }
  out += "<h2>Scenario</h2>\n" + table(scenario_rows(problem, plan));
  out += fmt::format("<p class=\"soft\">waywright {}</p>\n<p class=\"soft\" id=\"timing\">load {:.1f} ms, prepare {:.1f} ms, plan {:.1f} ms, prove {:.1f} ms</p>\n</body>\n</html>\n",
                     escaped(plan.version), 1000.0 * plan.timing.load, 1000.0 * plan.timing.prepare, 1000.0 * plan.timing.plan,
                     1000.0 * plan.timing.prove);
  return out;
}

}  // namespace waywright
