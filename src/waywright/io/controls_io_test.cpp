#include "waywright/io/controls_io.hpp"

#include <gtest/gtest.h>

#include "waywright/drive/test_plans.hpp"
#include "waywright/io/json_reader.hpp"

namespace waywright {
namespace {

using namespace drive_test;

TEST(ControlsIo, SeriesHaveTheColumnsOfTheDriveAndReadBackToTheSameBits) {
  const std::pair<Vehicle, std::string> cases[] = {{trolley(), "t,v,w,right,left,x,y,heading"},
                                                   {mecanum_base(), "t,v,v_left,w,front_left,front_right,rear_left,rear_right,x,y,heading"}};
  for (const auto& [vehicle, header] : cases) {
    Plan plan = judged(trolley(), trolley_path());
    plan.scenario.vehicle = vehicle;
    const ExactControls c = exact_controls(plan, 0.05);
    const std::string csv = controls_csv(vehicle, c.rows);
    EXPECT_EQ(csv.substr(0, csv.find('\n')), header);
    const auto json = parse_json(controls_json(plan, c), "controls.json");
    ASSERT_TRUE(json) << json.error().message();
    std::string names;
    for (const auto& [name, values] : (*json)["series"].items()) {
      names += (names.empty() ? "" : ",") + name;
      EXPECT_EQ(values.size(), c.rows.size());
    }
    EXPECT_EQ(names, header);
    for (std::size_t k = 0; k < c.rows.size(); ++k) {
      EXPECT_EQ((*json)["series"]["v"][k].get<double>(), c.rows[k].twist.forward);
      EXPECT_EQ((*json)["series"]["w"][k].get<double>(), c.rows[k].twist.turn);
      EXPECT_EQ((*json)["series"]["heading"][k].get<double>(), c.rows[k].pose.heading);
    }
    EXPECT_EQ((*json)["end_error"]["position"].get<double>(), c.end.position);
  }
}

}  // namespace
}  // namespace waywright
