// Seeded mutations of valid files: whatever comes, the readers answer with a value or one sentence, and what
// they accept is written and read back the same.
#include <gtest/gtest.h>

#include "waywright/core/random.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

using test::fingerprint;

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_{Random::stream(seed, 0)} {}

  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(random_.integer(0, static_cast<std::int64_t>(n) - 1));
  }

  /// A few bytes changed, taken away, doubled or moved.
  std::string bytes(std::string text) {
    static const std::string alphabet = "{}[],:\"\\0123456789.eE+-truefalsn \n\t\x01\x7f\x80\xc3\xff";
    for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      const std::size_t count = 1 + below(below(4) == 0 ? 200 : 4);
      switch (below(4)) {
        case 0:
          text[at] = alphabet[below(alphabet.size())];
          break;
        case 1:
          text.erase(at, count);
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), count));
          break;
        default:
          text.insert(at, 1, alphabet[below(alphabet.size())]);
          break;
      }
    }
    return text;
  }

  /// A few values of the tree replaced, removed, renamed or doubled: still JSON, and deep in the readers.
  std::string tree(Json json) {
    for (std::size_t edits = 1 + below(3); edits > 0; --edits) edit(json);
    return json.dump(-1, ' ', false, Json::error_handler_t::ignore);
  }

 private:
  Json other() {
    static const Json pool = Json::parse(
        R"([null, true, false, 0, 1, -1, 2, 3, 0.5, -0.0, 1e-300, 5e-324, 1e6, 1.0000001e6, 1e9, 1e300, 1.7e308,
        9223372036854775807, 18446744073709551615, -9223372036854775808, "", "x", "dock", "undock", "tricycle", "turn", "poses", "a\u0000b", [], {}, [0],
        [0, 0], [0, 0, 0], [[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [1, 0], [0, 1]], [[[0, 0], [1, 0]], [[1, 1], [2, 1]]], {"disc": 0}, {"x": {}},
        {"pose": [0, 0, 0]}, [[[[[[[[1]]]]]]]]])");
    return pool[below(pool.size())];
  }

  void edit(Json& json) {
    Json* at = &json;
    for (std::size_t steps = 1 + below(7); steps > 0 && at->is_structured() && !at->empty(); --steps)
      at = child(*at);
    if (at->is_structured() && !at->empty() && below(2) == 0) {
      Json* inner = child(*at);
      const Json copy = *inner;
      if (at->is_array()) {
        if (below(2) == 0)
          at->erase(below(at->size()));
        else
          at->push_back(copy);
      } else {
        auto& members = at->get_ref<Json::object_t&>();
        const std::string key = (members.begin() + static_cast<std::ptrdiff_t>(below(members.size())))->first;
        if (below(3) == 0)
          at->erase(key);
        else
          (*at)[below(2) == 0 ? bytes(key) : "transform"] = below(2) == 0 ? copy : other();
      }
    } else if (at->is_number() && below(2) == 0) {
      *at =
          at->get<double>() * (below(2) == 0 ? -1.0 : random_.uniform(0.0, 3.0)) + random_.uniform(-0.1, 0.1);
    } else {
      *at = other();
    }
  }

  Json* child(Json& json) {
    if (json.is_array()) return &json[below(json.size())];
    auto& members = json.get_ref<Json::object_t&>();
    return &(members.begin() + static_cast<std::ptrdiff_t>(below(members.size())))->second;
  }

  Random random_;
};

struct Count {
  int accepted = 0;
  int refused = 0;
};

/// One sentence: not empty, no line breaks, no control characters.
void expect_sentence(const InputError& error, const std::string& text) {
  const std::string sentence = error.message();
  EXPECT_GT(error.problem.size(), 5U) << text;
  for (const char c : sentence)
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) << sentence << "\n" << text;
}

TEST(IoFuzz, ScenariosAreReadOrRefused) {
  Mutator mutate{20260101};
  Count count;
  const std::string inlined = scenario_json(parse_scenario(test::full_scenario, "s", {}).value());
  for (const std::string& base :
       {std::string{test::full_scenario}, std::string{test::least_scenario}, inlined}) {
    const Json json = Json::parse(base);
    for (int i = 0; i < 10'000; ++i) {
      const std::string text = i % 2 == 0 ? mutate.bytes(base) : mutate.tree(json);
      const auto scenario = parse_scenario(text, "s.json", "nowhere");
      if (!scenario) {
        ++count.refused;
        expect_sentence(scenario.error(), text);
        continue;
      }
      ++count.accepted;
      const auto again = parse_scenario(scenario_json(*scenario), "again", "nowhere");
      ASSERT_TRUE(again) << again.error().message() << "\n" << text;
      ASSERT_EQ(fingerprint(*again), fingerprint(*scenario)) << text;
    }
  }
  EXPECT_GT(count.accepted, 1000) << "the mutations must reach beyond the first check";
  EXPECT_GT(count.refused, 10'000);
}

TEST(IoFuzz, PlansAreReadOrRefused) {
  Plan plan;
  plan.version = "1";
  plan.scenario = parse_scenario(test::least_scenario, "s", {}).value();
  plan.path.pieces = {{Line{{0, 0}, {1, 0}}, 1},
                      {Arc{{1, 0, 0}, 0.5, 1}, 1},
                      {Spline{SplineKind::quintic, {{2, {Vec2{0, 0}, {1, 0}, {1, 1}}}}}, -1},
                      {Turn{{1, 1}, 0.5, 0.5}, 0},
                      {PoseSequence{{{1, 1, 1}, {2, 1, 1}}}, -1}};
  plan.samples = {Sample{}, Sample{}, Sample{}};
  plan.certificate.tightest = Pose{};
  plan.explanation = {"why"};
  plan.alternatives = {{"left", true, 1.0, "taken", {}, {}}};
  plan.parameters = {{"a", 1.0}};
  const std::string base = plan_json(plan);
  const Json json = Json::parse(base);
  Mutator mutate{20260102};
  Count count;
  for (int i = 0; i < 30'000; ++i) {
    const std::string text = i % 2 == 0 ? mutate.bytes(base) : mutate.tree(json);
    const auto read = parse_plan(text, "nowhere/plan.json");
    if (!read) {
      ++count.refused;
      expect_sentence(read.error(), text);
      continue;
    }
    ++count.accepted;
    const std::string written = plan_json(*read);
    const auto again = parse_plan(written, "nowhere/again.json");
    ASSERT_TRUE(again) << again.error().message() << "\n" << text;
    ASSERT_EQ(plan_json(*again), written) << text;
  }
  EXPECT_GT(count.accepted, 1000);
  EXPECT_GT(count.refused, 10'000);
}

TEST(IoFuzz, PosesAreReadOrRefused) {
  const std::string base =
      "# "
      "poses\nx,y,heading,direction\n0,0,0,1\n1,0,0.1,1\n1,0,0.1,-1\n0.5,0,0.1,-1\n0.5,0,0.6,0\n0.5,1,0.7,"
      "1\n";
  Mutator mutate{20260103};
  Count count;
  for (int i = 0; i < 30'000; ++i) {
    const std::string text = mutate.bytes(base);
    const auto path = parse_poses_csv(text, "p.csv");
    if (!path) {
      ++count.refused;
      expect_sentence(path.error(), text);
      continue;
    }
    ++count.accepted;
    for (std::size_t k = 0; k < path->pieces.size(); ++k) {
      const Piece& piece = path->pieces[k];
      ASSERT_EQ(piece.direction == 0, std::holds_alternative<Turn>(piece.curve)) << text;
      ASSERT_TRUE(is_finite(start_pose(piece)) && is_finite(end_pose(piece))) << text;
      if (k == 0) continue;
      const Pose before = end_pose(path->pieces[k - 1]);
      ASSERT_EQ(before.position(), start_pose(piece).position()) << text;
      ASSERT_NEAR(shorter_turn(before.heading, start_pose(piece).heading), 0.0, 1e-9) << text;
    }
  }
  EXPECT_GT(count.accepted, 1000);
  EXPECT_GT(count.refused, 5'000);
}

}  // namespace
}  // namespace waywright
