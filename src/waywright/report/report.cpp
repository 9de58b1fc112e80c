#include "waywright/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/report/charts.hpp"
#include "waywright/report/page.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/report/scene_search.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/report/tables.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_repairs = 6;  // told at the top; all of them stand in the scenario's table

constexpr std::string_view styles_of_pages = R"(
:root{color-scheme:light dark;--ink:#1b1f24;--soft:#5b6570;--paper:#fff;--line:#d8dde2;--good:#00664f;--bad:#a0001c;--tint:#f4f6f8}
@media (prefers-color-scheme:dark){:root{--ink:#e8ecf0;--soft:#a7b1bb;--paper:#14181d;--line:#343c45;--good:#4fd6ac;--bad:#ff9a9a;--tint:#1c2229}}
body{font:15px/1.5 system-ui,-apple-system,"DejaVu Sans",sans-serif;color:var(--ink);background:var(--paper);margin:0 auto;max-width:1240px;padding:20px}
h1{font-size:22px;margin:0}h2{font-size:16px;margin:26px 0 8px}.verdict{font-size:18px;font-weight:700;margin:4px 0 14px}
.good{color:var(--good)}.bad{color:var(--bad)}.soft{color:var(--soft);font-size:13px}
.warn{border-left:4px solid var(--bad);background:var(--tint);padding:6px 10px;margin:8px 0}
.columns{display:flex;flex-wrap:wrap;gap:28px;align-items:flex-start;margin-top:14px}.columns>div{flex:1 1 330px;min-width:0}.columns>.wide{flex:2.1 1 600px}
svg{max-width:100%;height:auto;display:block}.legend{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:4px 18px;margin:8px 0 0;font-size:13px;color:var(--soft)}
.legend li{margin:0;display:flex;align-items:center;gap:6px}.legend svg{flex:none}.narrow{display:none}table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:4px 8px 4px 0;border-bottom:1px solid var(--line);vertical-align:top}
th{font-weight:600}td .soft{display:block}td.number{white-space:nowrap}tr.chosen{background:var(--tint)}ul{padding-left:20px;margin:0}li{margin:5px 0}
@media(max-width:640px){body{padding:14px 12px}.columns{gap:8px}.columns>div,.columns>.wide{flex-basis:100%}.broad{display:none}.narrow{display:block}
.scene .ww .small,.scene .ww .note,.scene .ww .number{font-size:24px}.scene .ww .tighttext,.scene .ww .name{font-size:28px}.scene .ww .tighttext.note{font-size:22px}.scene .ww .fwd,.scene .ww .back{stroke-width:5}}
@media print{body{max-width:none}.columns{display:block}}
)";

std::string top(const Plan& plan) {
  const bool good = plan.status == Status::solved;
  const std::string name = plan.scenario.name.empty() ? "Plan" : plan.scenario.name;
  std::string out = fmt::format("<h1>{}</h1>\n<p class=\"verdict {}\">{}</p>\n", escaped(name),
                                good ? "good" : "bad", escaped(headline(plan)));
  if (!plan.reason.empty()) out += fmt::format("<p>{}</p>\n", escaped(reason_once(plan, true)));
  for (const std::string& warning : warnings(plan))
    out += fmt::format("<p class=\"warn\">{}</p>\n", escaped(warning));
  const std::vector<std::string>& repairs = plan.scenario.map.notes;
  if (!repairs.empty()) {
    out += "<p class=\"warn\">Noted on loading: ";
    for (std::size_t i = 0; i < repairs.size() && i < most_repairs; ++i)
      out += (i > 0 ? "; " : "") + escaped(repairs[i]);
    out += repairs.size() > most_repairs
               ? fmt::format("; and {} more, see Scenario.</p>\n", repairs.size() - most_repairs)
               : ".</p>\n";
  }
  return out;
}

}  // namespace

std::string proof_html(const Plan& plan) {
  const Certificate& c = plan.certificate;
  if (!(c.checked_length > 0.0)) return {};
  if (!c.collision_free)
    return "<h2>What is proven</h2>\n<p>No clearance could be proven for this path.</p>\n";
  if (plan.status != Status::solved) {
    return fmt::format(
        "<h2>What is proven</h2>\n<p>The footprint keeps {} from everything, but the path is not what was "
        "asked for: {}</p>\n",
        clearance_words(c), escaped(as_sentence(plan.reason, plan.planner)));
  }
  const std::string nearer =
      is_beyond_measure(c)
          ? "every point of the footprint stays " + clearance_words(c) + " from anything"
          : "no point of the footprint comes nearer than " + clearance_words(c) + " to anything";
  return fmt::format(
      "<h2>What is proven</h2>\n<p>Along {:.3f} m of exact curves, between the samples too, {} on the map, "
      "at any pose within the pose error. The bound is at "
      "most {:.1f} mm under the truth. Assumed: the map shows everything, the footprint covers the whole "
      "vehicle, and the vehicle stays within the pose "
      "error.{}</p>\n",
      c.checked_length, nearer, 1000.0 * c.tolerance,
      plan.scenario.moving.empty() ? std::string{}
                                   : fmt::format(" Of what moves: more than {:.1f} mm at every time of the plan, wherever within its spread it is; assumed is that it moves as predicted.",
                                                 1000.0 * plan.scenario.clearance));
}

namespace {

std::string side(const Problem& problem, const Plan& plan) {
  std::string out;
  if (const auto sentences = explanation_once(plan, true); !sentences.empty()) {
    out += plan.samples.empty() ? "<h2>What happened</h2>\n<ul>\n" : "<h2>Why this path</h2>\n<ul>\n";
    for (const std::string& sentence : sentences) out += fmt::format("<li>{}</li>\n", escaped(sentence));
    out += "</ul>\n";
  }
  if (plan.samples.empty()) return out + alternatives_table(plan);
  return out + "<h2>Figures</h2>\n" + metric_table(problem, plan) + proof_html(plan);
}

}  // namespace

std::string_view page_styles() { return styles_of_pages; }

std::string plan_svg(const Problem& problem, const Plan& plan) {
  return scene_svg(problem, plan, picture_width);
}

std::string search_picture_svg(const Problem& problem, const Plan& plan) { return plan.search ? search_svg(problem, plan, picture_width) : std::string{}; }

std::string report_html(const Problem& problem, const Plan& plan) {
  const std::string search = plan.search ? "<h2>The search</h2>\n" + search_picture_svg(problem, plan) : std::string{};
  return page_html(plan, {scene_html(problem, plan, picture_width), charts_html(problem, plan) + search, side(problem, plan), plan.samples.empty() ? "" : alternatives_table(plan),
                          scenario_table(problem, plan)});
}

std::string page_html(const Plan& plan, const PageParts& parts) {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">"
      "<title>{}</title>\n<style>{}</style></head>\n<body>\n",
      escaped(plan.scenario.name.empty() ? "Plan" : plan.scenario.name), styles_of_pages);
  out += top(plan) + "<div class=\"columns\"><div class=\"wide\">\n" + parts.picture;
  if (!parts.charts.empty()) out += "<h2>Along the path</h2>\n" + parts.charts;
  out += "</div><div>\n" + parts.side + "</div></div>\n" + parts.below;
  out += "<h2>Scenario</h2>\n" + parts.scenario;
  out += fmt::format(
      "<p class=\"soft\">waywright {}</p>\n<p class=\"soft\" id=\"timing\">load {:.1f} ms, prepare {:.1f} "
      "ms, plan {:.1f} ms, prove {:.1f} ms</p>\n</body>\n</html>\n",
      escaped(plan.version), 1000.0 * plan.timing.load, 1000.0 * plan.timing.prepare,
      1000.0 * plan.timing.plan, 1000.0 * plan.timing.prove);
  return out;
}

}  // namespace waywright
