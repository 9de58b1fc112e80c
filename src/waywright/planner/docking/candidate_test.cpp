#include "waywright/planner/docking/candidate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"

namespace waywright {
namespace {

using fixture::Id;

DockingPattern random_pattern(const PreparedDocking& prepared, Random& random) {
  const double sign = random.uniform() < 0.7 ? 1.0 : -1.0;
  const Side side = sign > 0 ? Side::left : Side::right;
  const DockingTask& task = prepared.task();
  const Pose transition = task.frame.to_world(make_pose(
      {random.uniform(2.0, 6.0), sign * random.uniform(1.5, 6.0)}, transition_heading(side, task.dock.heading, random.uniform(-0.6, 0.6))));
  return docking_pattern(prepared.problem().start(), prepared.problem().goal(), transition, {0.0, 0.0, 0.3});
}

double least_clearance(const Problem& problem, const std::vector<Sample>& samples, double enough) {
  double least = enough;
  for (const Sample& s : samples) {
    least = std::min(least, problem.world().clearance(problem.vehicle().footprint, s.pose(), enough).clearance);
  }
  return least;
}

TEST(Candidate, FreeIsWhatKeepsItsClearanceAtEveryMillimetre) {
  for (const Id id : {Id::d0, Id::d2}) {
    const Problem problem = fixture::problem(id);
    const PreparedDocking prepared{problem};
    CandidateEvaluator evaluator{prepared};
    Random random{7};
    int free = 0;
    for (int i = 0; i < 200; ++i) {
      const DockingPattern pattern = random_pattern(prepared, random);
      const CandidateScore score = evaluator.evaluate(pattern);
      const Path path = pattern_path(splines_of(pattern));
      const auto samples = sample(path, 2.4, 1e-4, 0.004);
      const double least = least_clearance(problem, samples, 0.2);
      EXPECT_EQ(score.free, score.reach == 1.0);
      if (score.free) {
        ++free;
        EXPECT_GE(least, problem.required_clearance()) << i;
      } else {
        // Refused only for something that comes nearer than what is wanted, or misses it by less than the bow allowed for.
        EXPECT_LE(least, prepared.wanted_clearance() + 0.001) << i;
        EXPECT_LT(problem.world().clearance(problem.vehicle().footprint, score.blocked_at, 1.0).clearance,
                  prepared.wanted_clearance() + 0.03)
            << i;
      }
    }
    EXPECT_GT(free, 20);
  }
}

Problem with_rate_limit(Id id) {
  Scenario scenario = fixture::station(id);
  scenario.vehicle.limits.curvature_rate = 1.5;
  return Problem::prepare(scenario).value();
}

TEST(Candidate, MeasuresAreThoseOfTheCurve) {
  const Problem problem = with_rate_limit(Id::d0);
  const Problem unlimited = fixture::problem(Id::d0);
  const PreparedDocking unlimited_prepared{unlimited};
  CandidateEvaluator unlimited_evaluator{unlimited_prepared};
  const PreparedDocking prepared{problem};
  CandidateEvaluator evaluator{prepared};
  Random random{11};
  for (int i = 0; i < 100; ++i) {
    const DockingPattern pattern = random_pattern(prepared, random);
    const CandidateScore score = evaluator.measure(pattern);
    const auto samples = sample(pattern_path(splines_of(pattern)), 1.0, 1e-5, 0.01);
    const PathMeasures exact = measure_samples(samples);
    EXPECT_NEAR(score.measures.length, samples.back().s, 1e-5 * samples.back().s);
    EXPECT_NEAR(score.measures.curvature_change, exact.curvature_change, 0.003 * exact.curvature_change + 1e-4);
    EXPECT_NEAR(score.measures.max_curvature, exact.max_curvature, 0.002 * exact.max_curvature);
    double rate = 0.0;
    for (const BezierSpan& span : {pattern.back, pattern.forth}) {
      for (int k = 0; k <= 2000; ++k) rate = std::max(rate, std::abs(evaluate(span, k / 2000.0).curvature_rate));
    }
    EXPECT_NEAR(score.max_curvature_rate, rate, 0.002 * rate);
    EXPECT_EQ(score.excess > 0.0, rate > 1.5 || score.measures.max_curvature > 0.8) << i;
    const CandidateScore without = unlimited_evaluator.measure(pattern);
    EXPECT_EQ(without.max_curvature_rate, 0.0);
    EXPECT_EQ(without.measures.curvature_change, score.measures.curvature_change);
  }
}

TEST(Candidate, EveryInstructionSetGivesTheSameBits) {
  const Problem problem = with_rate_limit(Id::d2);
  const PreparedDocking prepared{problem};
  for (const lanes::Kernels& kernels : lanes::available()) {
    CandidateEvaluator plain{prepared, lanes::available().front()};
    CandidateEvaluator wide{prepared, kernels};
    Random random{5};
    for (int i = 0; i < 2000; ++i) {
      const DockingPattern pattern = random_pattern(prepared, random);
      const CandidateScore a = plain.evaluate(pattern);
      const CandidateScore b = wide.evaluate(pattern);
      ASSERT_EQ(a.measures.length, b.measures.length) << kernels.name;
      ASSERT_EQ(a.measures.curvature_change, b.measures.curvature_change) << kernels.name;
      ASSERT_EQ(a.measures.max_curvature, b.measures.max_curvature) << kernels.name;
      ASSERT_EQ(a.max_curvature_rate, b.max_curvature_rate) << kernels.name;
      ASSERT_EQ(a.reach, b.reach) << kernels.name;
      ASSERT_EQ(a.deficit, b.deficit) << kernels.name;
      ASSERT_EQ(a.free, b.free) << kernels.name;
      ASSERT_EQ(a.blocked_at, b.blocked_at) << kernels.name;
    }
  }
}

TEST(Candidate, GradedCostOrdersFeasibleLimitAndContact) {
  CandidateScore feasible;
  feasible.free = true;
  feasible.reach = 1.0;
  CandidateScore sharp = feasible;
  sharp.excess = 0.2;
  CandidateScore late = feasible;
  late.free = false;
  late.reach = 0.8;
  CandidateScore early = late;
  early.reach = 0.2;
  EXPECT_LT(graded_cost(feasible, 1.0), graded_cost(sharp, 1.0));
  EXPECT_LT(graded_cost(sharp, 1.0), graded_cost(late, 1.0));
  EXPECT_LT(graded_cost(late, 1.0), graded_cost(early, 1.0));
  EXPECT_GE(graded_cost(late, 1.0), 1000.0);
}

}  // namespace
}  // namespace waywright
