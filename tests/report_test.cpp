// What a person sees: complete, well-formed, and the same every time.
#include <gtest/gtest.h>

#include <regex>
#include <stack>

#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/svg_writer.hpp"

namespace waywright {
namespace {

struct Reported {
  Plan plan;
  std::string svg, html, text;
};

Reported report(const std::string& example, const std::string& name = "") {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + example).value();
  if (!name.empty()) s.name = name;
  const Problem problem = Problem::prepare(std::move(s)).value();
  Reported r;
  r.plan = *solve(problem);
  r.plan.timing = {};
  r.svg = plan_svg(problem, r.plan);
  r.html = report_html(problem, r.plan);
  r.text = plan_text(r.plan);
  return r;
}

/// Every tag that opens closes, in order.
void expect_balanced(const std::string& text) {
  const std::regex tag{R"(<(/?)([a-zA-Z0-9]+)([^>]*)>)"};
  std::stack<std::string> open;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), tag); it != std::sregex_iterator(); ++it) {
    const std::string name = (*it)[2];
    const std::string rest = (*it)[3];
    if (name == "meta" || (!rest.empty() && rest.back() == '/')) continue;
    if ((*it)[1].length() == 0) {
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

TEST(Report, IsCompleteForASolvedPlan) {
  const Reported r = report("dock_cluttered.json");
  expect_clean(r.svg);
  expect_clean(r.html);
  for (const char* part : {"Solved and proven", "Why this path", "Figures", "Along the path", "What was tried", "What is proven", "Scenario", "left side", "right side",
                           "Curvature in 1/m", "Clearance in m", "Speed in m/s", "class=\"sweep\"", "class=\"zone\"", "class=\"tight\"", "class=\"shelf\""}) {
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
  EXPECT_NE(r.html.find("What happened"), std::string::npos);
  EXPECT_NE(r.html.find("before it met obstacle"), std::string::npos);
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

TEST(SvgNumbers, AreFixedAndFinite) {
  EXPECT_EQ(fixed(1.0), "1");
  EXPECT_EQ(fixed(-0.001), "0");
  EXPECT_EQ(fixed(1e9), "1000000000");
  EXPECT_EQ(fixed(0.125, 2), "0.12");
  EXPECT_EQ(fixed(1.0 / 0.0), "0");
}

}  // namespace
}  // namespace waywright
