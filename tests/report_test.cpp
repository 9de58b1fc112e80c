// What a person sees: complete, well-formed, and the same every time.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <regex>
#include <set>
#include <stack>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/import.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/charts.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/scene.hpp"
#include "waywright/report/svg_writer.hpp"
#include "waywright/report/words.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

struct Reported {
  Plan plan;
  std::string svg, html, text;
};

Reported report(const std::string& example, const std::string& name = "", const std::string& planner = "", Parameters parameters = {}) {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + example).value();
  if (!name.empty()) s.name = name;
  if (!planner.empty()) s.planner = {planner, std::move(parameters)};
  const Problem problem = Problem::prepare(std::move(s)).value();
  Reported r;
  r.plan = *solve(problem);
  r.plan.timing = {};
  r.svg = plan_svg(problem, r.plan);
  r.html = report_html(problem, r.plan);
  r.text = plan_text(r.plan);
  return r;
}

/// Every tag that opens closes, in order. (By hand: std::regex recurses over the length of a tag, and paths are long.)
void expect_balanced(const std::string& text) {
  std::stack<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const bool closes = text[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = text.substr(begin, text.find_first_of(" />", begin) - begin);
    if (name == "meta" || name == "!doctype" || text[end - 1] == '/') continue;
    if (!closes) {
      open.push(name);
      continue;
    }
    ASSERT_FALSE(open.empty()) << name;
    ASSERT_EQ(open.top(), name);
    open.pop();
  }
  EXPECT_TRUE(open.empty());
}

void expect_clean(const std::string& text) {
  EXPECT_FALSE(std::regex_search(text, std::regex{"[^a-zA-Z](nan|inf)[^a-zA-Z]"}));
  expect_balanced(text);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(Report, IsCompleteForASolvedPlan) {
  const Reported r = report("dock_cluttered.json");
  expect_clean(r.svg);
  expect_clean(r.html);
  for (const char* part : {"Solved and proven", "Why this path", "Figures", "Along the path", "What was tried", "What is proven", "Scenario", "left side", "right side",
                           "Curvature in 1/m", "Steering angle in degrees", "Clearance in m, cut off at 0.5 m", "Speed in m/s", "with pose error", "class=\"sweep\"", "class=\"zone\"", "class=\"tight\"", "class=\"shelf\""}) {
    EXPECT_NE(r.html.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(r.html.find("http://"), r.html.find("http://www.w3.org"));  // self-contained: nothing is fetched
  EXPECT_EQ(r.html.find("https://"), std::string::npos);
  EXPECT_LT(r.html.size(), 300000U);
}

TEST(Report, SaysWhatHappenedWhereThereIsNoPath) {
  const Reported r = report("dock_impossible.json");
  expect_clean(r.svg);
  expect_clean(r.html);
  EXPECT_NE(r.html.find("No path"), std::string::npos);
  EXPECT_NE(r.html.find("What was tried"), std::string::npos);
  EXPECT_NE(r.html.find("before it met obstacle"), std::string::npos);
  EXPECT_NE(r.html.find("No docking pattern fits: left side blocked by obstacle"), std::string::npos);
  // Both sides are seen to touch, and the legend says what is drawn.
  EXPECT_GE(count_of(r.svg, "class=\"hit\""), 4U);
  EXPECT_NE(r.svg.find("tried in vain"), std::string::npos);
  EXPECT_EQ(r.svg.find("what was not taken"), std::string::npos);
}

TEST(Report, MarksWhereTheStartTouches) {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/dock_middle.json").value();
  s.start = {7.3, 9.9, 0.0};
  const Problem problem = Problem::prepare(std::move(s)).value();
  const Plan plan = *solve(problem);
  ASSERT_EQ(plan.status, Status::start_in_collision);
  const std::string html = report_html(problem, plan);
  expect_clean(html);
  EXPECT_EQ(count_of(html, "<polygon class=\"hit\""), 1U);
  EXPECT_EQ(count_of(html, "<circle class=\"tightdot\""), 1U);
  EXPECT_NE(html.find("0.0000 rad (0.00°)"), std::string::npos);
}

TEST(Report, DrawsWhereAnImportedPathTouches) {
  const Problem problem = Problem::prepare(read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/dock_middle.json").value()).value();
  const Plan plan = judge_imported(problem, {{{PoseSequence{{{9.5, 7.0, 0.0}, {11.9, 7.0, 0.0}}}, 1}}});
  ASSERT_EQ(plan.status, Status::unproven);
  const std::string html = report_html(problem, plan);
  EXPECT_EQ(count_of(html, "<polygon class=\"hit\""), 1U);
  EXPECT_NE(html.find(">touches<"), std::string::npos);
  EXPECT_EQ(html.find("0.0000 m</td>"), html.find("0.0000 m</td></tr>\n<tr><th scope=\"row\">Mean clearance"));
  EXPECT_NE(html.find("<th scope=\"row\">Proven clearance</th><td>none"), std::string::npos);
}

TEST(Report, TellsTheTightestSpotBesideTheGapThatIsChosen) {
  const Reported docked = report("dock_middle.json");
  EXPECT_NE(docked.html.find("Tightest before the final straight"), std::string::npos);
  EXPECT_NE(docked.svg.find("class=\"spot\""), std::string::npos);
  EXPECT_NE(report("undock_loaded.json").html.find("Tightest after the first straight"), std::string::npos);
  // Where a box is tighter than the gap, that is the spot, and there is no second one.
  EXPECT_EQ(report("dock_cluttered.json").html.find("Tightest before the final straight"), std::string::npos);
}

TEST(Report, CountsAndMarksStopsWhereTheCurvatureJumps) {
  const Reported r = report("goal_pose.json", "", "ompl_rrt_connect", {{"space", std::string{"reeds_shepp"}}});
  expect_clean(r.html);
  std::size_t stops = 0;
  for (std::size_t i = 1; i < r.plan.samples.size(); ++i) {
    if (r.plan.samples[i].direction == r.plan.samples[i - 1].direction && is_curvature_jump(r.plan.samples[i - 1], r.plan.samples[i])) ++stops;
  }
  ASSERT_GT(stops, 0U);
  EXPECT_EQ(count_of(r.svg, "<rect class=\"stop\""), stops + 1);  // and the legend's
  EXPECT_NE(r.html.find("Stops where the curvature jumps"), std::string::npos);
  EXPECT_NE(r.text.find(fmt::format("stops at curv. jumps   {}", stops)), std::string::npos) << r.text;
  // About a free goal the sides of a shelf mean nothing.
  EXPECT_EQ(r.svg.find("class=\"zone\""), std::string::npos);
}

TEST(Report, ShowsEveryZoneWithItsRule) {
  const Reported r = report("grid_zones.json");
  ASSERT_EQ(r.plan.status, Status::solved) << r.plan.reason;
  expect_clean(r.svg);
  expect_clean(r.html);
  // Each once in the map and once in the legend.
  EXPECT_EQ(count_of(r.svg, "class=\"zonedirected\""), 3U);
  for (const char* style : {"zoneforbidden", "zonepreferred", "zonepenalty", "zonespeed"}) EXPECT_EQ(count_of(r.svg, fmt::format("class=\"{}\"", style)), 2U) << style;
  EXPECT_GE(count_of(r.svg, "class=\"zonearrowhead\""), 2U);
  for (const char* text : {"aisle east", "picking, × 3", "main road, × 0.6", "crossing, 0.3 m/s", "charging", "one way, along the arrows"}) EXPECT_NE(r.svg.find(text), std::string::npos) << text;
  for (const char* text : {"zone &quot;crossing&quot;", "at most 0.3 m/s", "one way, 180.0°", "Zones weigh"}) EXPECT_NE(r.html.find(text), std::string::npos) << text;
  // The limit of the zone in the speed's chart, in both widths; where the vehicle turns on the spot, in every chart.
  EXPECT_EQ(count_of(r.html, "<polyline class=\"ceiling\""), 2U);
  EXPECT_NE(r.html.find("stepped line of the speed: limit of a zone"), std::string::npos);
  EXPECT_NE(r.html.find("pink line: turn on the spot"), std::string::npos);
  EXPECT_GE(count_of(r.html, "<line class=\"spin\""), 6U);
  const Reported tugger = report("grid_tugger.json");
  EXPECT_EQ(tugger.html.find("limit of a zone"), std::string::npos);
  EXPECT_EQ(report("dock_middle.json").html.find("<line class=\"spin\""), std::string::npos);
  EXPECT_EQ(count_of(tugger.svg, "<polygon class=\"zone"), 0U);
}

TEST(Report, CallsNothingProvenInAPathThatIsNot) {
  Reported r = report("grid_tugger.json");
  ASSERT_NE(r.svg.find("mm proven"), std::string::npos);
  r.plan.status = Status::unproven;  // for another reason than contact
  const Problem problem = Problem::prepare(r.plan.scenario).value();
  EXPECT_EQ(plan_svg(problem, r.plan).find("mm proven"), std::string::npos);
}

TEST(Report, APathWhoseProofWasInterruptedIsKept) {
  const Reported r = report("dock_middle.json");
  const Problem problem = Problem::prepare(r.plan.scenario).value();
  const std::atomic<bool> raised{true};
  Plan plan = judge(problem, r.plan.path, &raised);
  EXPECT_EQ(plan.status, Status::canceled);
  EXPECT_EQ(plan.reason, "canceled before the path was proven; the path is kept, and verify can prove it");
  EXPECT_EQ(plan.samples.size(), r.plan.samples.size());
  EXPECT_EQ(plan.metrics.length, r.plan.metrics.length);
  EXPECT_FALSE(plan.certificate.collision_free);
  EXPECT_EQ(plan.certificate.checked_length, 0.0);
  EXPECT_EQ(headline(plan), "Interrupted: a path, not proven");
  EXPECT_NE(plan_text(plan).find("not proven: the run was interrupted"), std::string::npos);
  expect_clean(plan_svg(problem, plan));
  expect_clean(report_html(problem, plan));
  EXPECT_EQ(plan_svg(problem, plan).find("mm proven"), std::string::npos);
  const auto read = parse_plan(plan_json(plan), "plan.json");
  ASSERT_TRUE(read) << read.error().message();
  const auto verified = verify(*read).value();
  EXPECT_EQ(verified.fresh.status, Status::solved);
  EXPECT_EQ(verified.findings.front(), "the plan says that it is canceled, though its path can be proven");
}

TEST(Report, NumbersObstaclesAndTicksCoordinates) {
  const Reported r = report("dock_cluttered.json");
  EXPECT_EQ(count_of(r.svg, "class=\"number\""), r.plan.scenario.map.obstacles.size() + r.plan.scenario.map.lines.size());
  EXPECT_GT(count_of(r.svg, "class=\"axis\""), 8U);
}

TEST(Report, EscapesNames) {
  const Reported r = report("dock_narrow_side.json", "<b>\"x\" & 'y'</b>");
  expect_clean(r.html);
  EXPECT_EQ(r.html.find("<b>"), std::string::npos);
  EXPECT_NE(r.html.find("&lt;b&gt;&quot;x&quot; &amp; &#39;y&#39;&lt;/b&gt;"), std::string::npos);
}

TEST(Report, CropsLargeMapsToWhatMatters) {
  const Reported r = report("dock_warehouse.json");
  expect_clean(r.html);
  EXPECT_LT(r.html.size(), 500000U);
}

TEST(Report, TextIsTheGoldenOne) {
  const Reported r = report("dock_narrow_side.json");
  // The form is golden; figures of the search, which change when it does, are read as digits.
  EXPECT_EQ(std::regex_replace(r.text.substr(0, r.text.find("  - ")), std::regex{"[0-9]+"}, "#"),
            "one side too narrow: solved\n"
            "  planner                pattern_docking\n"
            "  length                 #.# m\n"
            "  proven clearance       #.# m\n"
            "  greatest curvature     #.# #/m (limit #.#)\n"
            "  change of curvature    #.# #/m\n"
            "  direction changes      #\n"
            "  travel time            #.# s\n"
            "  effort                 # evaluations\n"
            "  time                   plan #.# ms, prove #.# ms\n");
  EXPECT_NE(r.text.find("The left side of the shelf was left out: it is 0.850 m wide, and the footprint's least width with the clearance on both sides "
                        "is 1.000 m; 0.150 m are missing."),
            std::string::npos);
}

TEST(Words, ReasonAndExplanationDoNotRepeatEachOther) {
  Plan plan;
  plan.reason = "no pattern fits. On the left side a box stands. On the right side too";
  plan.explanation = {"On the left side a box stands.", "On the right side too."};
  EXPECT_EQ(reason_once(plan, false), "No pattern fits.");
  EXPECT_EQ(explanation_once(plan, false), plan.explanation);
  plan.alternatives = {{"left side", false, {}, "On the left side a box stands.", {}, {}}};
  EXPECT_EQ(explanation_once(plan, true), std::vector<std::string>{"On the right side too."});
  // A reason of its own stays whole, and a sentence that only wraps it goes.
  plan.reason = "the path touches obstacle 0";
  plan.explanation = {"Imported poses.", "This path is not proven: the path touches obstacle 0."};
  EXPECT_EQ(reason_once(plan, false), "The path touches obstacle 0.");
  EXPECT_EQ(explanation_once(plan, false), std::vector<std::string>{"Imported poses."});
  // Beside the table of what was tried, what that tells is left out.
  plan.explanation.clear();
  plan.reason = "no pattern fits; the second choice found none either: it ran out of budget";
  plan.alternatives = {{"RRTConnect", false, std::nullopt, "it ran out of budget.", {}, {}}};
  EXPECT_EQ(reason_once(plan, false), "No pattern fits; the second choice found none either: it ran out of budget.");
  EXPECT_EQ(reason_once(plan, true), "No pattern fits; the second choice found none either.");
}

TEST(Words, APlannersNameStaysAsItIs) {
  EXPECT_EQ(as_sentence("astar found nothing", "astar"), "astar found nothing.");
  EXPECT_EQ(as_sentence("no way leads there", "astar"), "No way leads there.");
  EXPECT_EQ(as_sentence("", "astar"), "");
}

TEST(Words, WorkThatWasCutShortIsSaid) {
  Plan plan;
  EXPECT_TRUE(warnings(plan).empty());
  plan.reproducible = false;
  ASSERT_EQ(warnings(plan).size(), 1U);
  EXPECT_NE(warnings(plan)[0].find("an interrupt"), std::string::npos);
  plan.scenario.budget.seconds = 1.0;
  EXPECT_NE(warnings(plan)[0].find("seconds"), std::string::npos);
}

TEST(SvgNumbers, AreFixedAndFinite) {
  EXPECT_EQ(fixed(1.0), "1");
  EXPECT_EQ(fixed(-0.001), "0");
  EXPECT_EQ(fixed(1e9), "1000000000");
  EXPECT_EQ(fixed(0.125, 2), "0.12");
  EXPECT_EQ(fixed(1.0 / 0.0), "0");
}

TEST(Report, ScenarioListsItsWaypoints) {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/waypoints_low.json").value();
  s.planner.parameters["evaluations"] = 50.0;
  const auto html_of = [](const Scenario& scenario) {
    const Problem problem = Problem::prepare(scenario).value();
    return report_html(problem, *solve(problem));
  };
  std::string html = html_of(s);
  const auto says = [&](const std::string& part) { return html.find(part) != std::string::npos; };
  ASSERT_EQ(s.waypoints.size(), 2U);
  EXPECT_TRUE(says(fmt::format("1: ({}, {}), 2: ({}, {})", s.waypoints[0].x, s.waypoints[0].y, s.waypoints[1].x, s.waypoints[1].y)));
  EXPECT_TRUE(says("each exactly"));
  s.waypoint_radius = 0.15;
  html = html_of(s);
  EXPECT_TRUE(says("each within 0.15 m"));
  expect_balanced(html);
  s.waypoint_radius = 0.0;
  s.waypoints.clear();
  html = html_of(s);
  EXPECT_FALSE(says("Waypoints"));
}

TEST(Report, ManyPathsInOnePictureDifferInColourOrDashes) {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/waypoints_low.json").value();
  s.planner.parameters["evaluations"] = 20.0;
  const Problem problem = Problem::prepare(s).value();
  const Plan plan = *solve(problem);
  std::vector<std::pair<std::string, const Plan*>> plans;
  for (int i = 0; i < 30; ++i) plans.emplace_back(fmt::format("plan {}", i), &plan);
  for (const std::string& svg : {overlay_svg(problem, plans, "", 800.0), clearances_svg(problem, plans, 800.0)}) {
    expect_clean(svg);
    std::set<std::string> drawn, named;
    const auto take = [&](const std::string& element, std::set<std::string>& into) {
      for (std::size_t at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1)) {
        const std::string tag = svg.substr(at, svg.find('>', at) - at);
        std::smatch stroke;
        if (std::string head = tag.substr(0, 200); std::regex_search(head, stroke, std::regex{"stroke=\"#[0-9a-f]+\"( stroke-dasharray=\"[^\"]+\")?"})) into.insert(stroke.str());
      }
    };
    take("<polyline fill=", drawn);
    take("<line x1=", named);
    EXPECT_EQ(drawn.size(), plans.size());
    EXPECT_EQ(named, drawn);
  }
}

}  // namespace
}  // namespace waywright
