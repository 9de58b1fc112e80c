// What a person sees of a mission in legs.
#include <fmt/format.h>

#include <algorithm>

#include "waywright/judge/legs.hpp"
#include "waywright/report/charts.hpp"
#include "waywright/report/mission_scene.hpp"
#include "waywright/report/page.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/report/tables.hpp"
#include "waywright/report/words.hpp"

namespace waywright {
namespace {

std::string charts(const Plan& plan, const std::vector<LegView>& legs) {
  AskedAlong asked;
  for (const LegView& leg : legs) {
    asked.clearance.insert(asked.clearance.end(), leg.clearance.begin(), leg.clearance.end());
    asked.zone_speed.insert(asked.zone_speed.end(), leg.zone_speed.begin(), leg.zone_speed.end());
    if (leg.required < asked.required) continue;  // with a load the pose error takes more: the most that a leg asks for is drawn
    asked.required = leg.required;
    asked.margin = leg.margin;
  }
  return asked.clearance.size() == plan.samples.size() ? charts_html(plan, asked) : "";
}

/// The explanation, each leg's sentences below its headline; what is told of several legs below one of its own.
std::string why(const Plan& plan) {
  std::vector<std::string> headlines;
  for (std::size_t i = 0; i < plan.legs.size(); ++i) headlines.push_back(leg_headline(plan.scenario, plan.legs, i));
  std::string out = plan.samples.empty() ? "<h2>What happened</h2>\n" : "<h2>Why this path</h2>\n";
  std::size_t next = 0;
  bool is_open = false, is_of_several = false;
  for (const std::string& sentence : explanation_once(plan, true)) {
    const auto headline = std::find(headlines.begin() + static_cast<std::ptrdiff_t>(next), headlines.end(), sentence);
    if (headline != headlines.end()) {
      next = static_cast<std::size_t>(headline - headlines.begin()) + 1;
      if (is_open) out += "</ul>\n";
      is_open = false;
      out += fmt::format("<p><b>{}</b></p>\n", escaped(sentence));
      continue;
    }
    if (!is_of_several && next == headlines.size() && tells_of_several_legs(sentence)) {
      out += fmt::format("{}<p><b>Several legs</b></p>\n", is_open ? "</ul>\n" : "");
      is_open = false;
      is_of_several = true;
    }
    if (!is_open) out += "<ul>\n";
    is_open = true;
    out += fmt::format("<li>{}</li>\n", escaped(sentence));
  }
  return out + (is_open ? "</ul>\n" : "");
}

}  // namespace

std::string plan_svg(const Plan& plan) { return mission_scene_svg(plan, leg_views(plan, false), picture_width); }

SmallPicture small_picture(const Plan& plan) { return mission_small_picture(plan, leg_views(plan, false)); }

std::string report_html(const Plan& plan) {
  const std::vector<LegView> legs = leg_views(plan, true);
  PageParts parts;
  parts.picture = mission_scene_html(plan, legs, picture_width) + legs_table(plan);
  parts.charts = charts(plan, legs);
  if (!plan.samples.empty()) parts.side = "<h2>Figures of the whole</h2>\n" + metric_table(plan) + proof_html(plan);
  parts.side += why(plan);
  parts.below = alternatives_table(plan);
  parts.scenario = scenario_table(plan);
  return page_html(plan, parts);
}

}  // namespace waywright
