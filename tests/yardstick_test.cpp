// The search's verdict on candidates against plain code: the frozen yardstick of the benchmarks.
#include <gtest/gtest.h>

#include <cstdio>

#include "bench/docking_scene.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/proof/collision.hpp"

namespace waywright {
namespace {

using bench::Clutter;

struct Verdicts {
  int free = 0;       ///< both
  int hit = 0;        ///< both
  int missed = 0;     ///< ours says hit, plain sees none at its poses, and there is one between them
  int cautious = 0;   ///< ours says hit, plain none, and there is none: within a millimetre of the wanted clearance
};

Verdicts compare(Clutter clutter, std::uint64_t seed, int count) {
  const Problem problem = Problem::prepare(bench::docking_scenario(clutter, seed)).value();
  const PreparedDocking prepared{problem};
  const yardstick::Scene scene = bench::scene_of(problem, problem.required_clearance());
  CandidateEvaluator evaluator{prepared};
  Random random{seed};
  Verdicts verdicts;
  for (int i = 0; i < count; ++i) {
    const DockingPattern pattern = bench::random_pattern(problem, prepared.task(), random);
    const CandidateScore ours = evaluator.evaluate(pattern);
    const yardstick::Verdict plain = yardstick::evaluate_boxes_first(scene, bench::candidate_of(pattern), lanes::samples);
    EXPECT_NEAR(ours.measures.curvature_change, plain.curvature_change, 1e-4 * plain.curvature_change + 1e-5);
    // At a near cusp the speed is a small difference of rounded numbers: the curvature of a circle of a millimetre is as good as any.
    const double rounding = plain.max_curvature < 1000.0 ? 1e-5 : 1e-4;
    EXPECT_GE(ours.measures.max_curvature, plain.max_curvature * (1.0 - rounding));
    if (ours.free && plain.hits == 0) {
      ++verdicts.free;
    } else if (!ours.free && plain.hits > 0) {
      ++verdicts.hit;
    } else if (ours.free) {
      ADD_FAILURE() << "candidate " << i << " was called free and hits at pose " << plain.first_hit;
    } else {
      // Plain looks at poses only. The proof's clearance of the whole motion tells who is right.
      const Motion motion{pattern_path(splines_of(pattern))};
      SweepMemory memory;
      const SweptClearance swept =
          swept_clearance(problem.world(), SweptBody{problem.vehicle().footprint}, motion.intervals(), {.tolerance = 1e-5}, memory);
      if (swept.upper <= problem.required_clearance()) {
        ++verdicts.missed;
      } else {
        ++verdicts.cautious;
        EXPECT_LT(swept.lower, prepared.wanted_clearance() + 0.0015) << "candidate " << i;
      }
    }
  }
  return verdicts;
}

void run(int count) {
  for (const Clutter clutter : {Clutter::boxes, Clutter::points}) {
    const Verdicts v = compare(clutter, 2, count);
    const char* name = clutter == Clutter::boxes ? "boxes" : "points";
    std::printf("%s: both free %d, both hit %d, hit between poses %d, within a millimetre and a half of the wanted clearance %d\n", name,
                v.free, v.hit, v.missed, v.cautious);
    EXPECT_GT(v.free, count / 200);
    EXPECT_GT(v.hit, count / 2);
    EXPECT_LT(v.cautious, count / 200);
  }
}

TEST(Yardstick, SameVerdictOnRandomCandidates) { run(4000); }
TEST(Yardstick, SameVerdictOnRandomCandidatesFull) { run(100000); }

}  // namespace
}  // namespace waywright
