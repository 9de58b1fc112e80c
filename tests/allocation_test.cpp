// Judging a docking path takes no memory once its workspaces are there: calls of operator new are counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "waywright/docking/docking.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/pattern_docking.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/speed/speed.hpp"
#include "waywright/study/generate.hpp"

namespace {

std::atomic<std::int64_t> allocations{0};

void* counted(void* memory) {
  ++allocations;
  if (memory == nullptr) throw std::bad_alloc{};
  return memory;
}

}  // namespace

// new[] and the others end up here. (Inlined, they look mismatched to the compiler.)
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, (size + a - 1) / a * a));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace waywright {
namespace {

using fixture::Id;

std::vector<Scenario> scenarios() {
  const Pose somewhere{-37.5, 12.25, 2.1};
  std::vector<Scenario> all{fixture::station(Id::d0), fixture::station(Id::d1, somewhere), fixture::station(Id::d2), fixture::station(Id::d3),
                            fixture::with_pockets(Manoeuvre::dock), fixture::with_pockets(Manoeuvre::undock)};
  Scenario s = fixture::station(Id::d2, somewhere);
  s.pose_error = {0.02, 0.01, 0.005};
  s.clearance = 0.04;
  s.vehicle.limits.curvature_rate = 1.0;
  s.vehicle.limits.angular_acceleration = 0.5;
  all.push_back(s);
  s.vehicle.footprint = {{}, 0.6};
  s.vehicle.drive = Differential{0.7};
  all.push_back(s);
  return all;
}

TEST(Allocation, JudgingADockingPathTakesNoMemory) {
  for (const Scenario& scenario : scenarios()) {
    const Problem problem = Problem::prepare(scenario).value();
    Budget budget{scenario.budget};
    const PlanningResult planned = PatternDockingPlanner{{}, std::make_shared<LatticeSearch>(), 1}.plan(problem, budget);
    ASSERT_TRUE(planned) << planned.error().failure.reason;

    ProofWorkspace proving{problem};
    std::vector<Sample> samples;
    samples.reserve(20'000);
    SpeedWorkspace speeds;
    speeds.reserve(samples.capacity());

    const std::int64_t before = allocations;
    const Path path = problem.whole_path(planned->path);
    const Proof proof = prove(problem, path, {}, proving);
    const Certificate certificate = proof.certificate;
    sample(path, problem.footprint().radius(), certificate.tolerance, 0.05, samples);
    const double time = assign_speed(samples, problem.vehicle(), 0.0, speeds);
    const double greatest = greatest_start_speed(samples, problem.vehicle(), speeds);
    EXPECT_EQ(allocations - before, 0) << path.pieces.size() << " pieces, " << samples.size() << " samples";

    EXPECT_TRUE(proof.holds());
    EXPECT_TRUE(certificate.tightest);
    EXPECT_GT(samples.size(), 100U);
    EXPECT_GT(time, 1.0);
    EXPECT_GE(greatest, 0.0);
  }
}

/// The first plan of a session already.
DockingPlan counted_plan(const Docking& docking) {
  auto session = DockingSession::on(docking);
  const std::int64_t before = allocations;
  const DockingPlan plan = [&] {
    const DockingPlan& made = session->plan();
    EXPECT_EQ(allocations - before, 0) << made.evaluations << " evaluations, " << made.samples.size() << " samples";
    return made;
  }();
  // With a flag, the best so far is proven while the search goes on: the answer is the same.
  std::atomic<bool> cancel{false};
  const std::int64_t then = allocations;
  const DockingPlan& watched = session->plan({}, &cancel);
  EXPECT_EQ(allocations - then, 0) << "with a flag";
  EXPECT_EQ(watched.status, plan.status);
  EXPECT_EQ(watched.evaluations, plan.evaluations);
  EXPECT_EQ(watched.cost, plan.cost);
  EXPECT_EQ(watched.certificate.clearance, plan.certificate.clearance);
  EXPECT_EQ(watched.samples.size(), plan.samples.size());
  for (std::size_t i = 0; i < std::min(watched.samples.size(), plan.samples.size()); ++i) {
    EXPECT_EQ(watched.samples[i].pose(), plan.samples[i].pose());
    EXPECT_EQ(watched.samples[i].t, plan.samples[i].t);
  }
  return plan;
}

void plans_without_memory(const Scenario& scenario, Status wanted) {
  const auto docking = Docking::prepare(scenario);
  ASSERT_TRUE(docking) << docking.error().message();
  const DockingPlan plan = counted_plan(*docking);
  EXPECT_EQ(plan.status, wanted);
  if (plan.status != Status::solved) return;
  // Carried on from half way, with the shelf a little elsewhere.
  const Handover half = handover_at(plan.path, plan.samples, 0.4 * plan.travel_time);
  Shelf shelf = std::get<Station>(scenario.mission).shelf;
  if (std::get<Station>(scenario.mission).manoeuvre == Manoeuvre::undock) return;
  shelf.center = shelf.center + Vec2{0.01, -0.01};
  const auto moved = docking->from(half.pose, half.motion, shelf);
  ASSERT_TRUE(moved) << moved.error().message();
  auto again = DockingSession::on(*moved);
  ASSERT_TRUE(again);
  const std::int64_t then = allocations;
  const DockingPlan& next = again->replan(plan, half.driven);
  EXPECT_EQ(allocations - then, 0) << (next.is_carried_on ? "carried on" : "planned anew");
}

TEST(Allocation, AWholePlanTakesNoMemory) {
  for (const Scenario& scenario : scenarios()) plans_without_memory(scenario, Status::solved);
}

TEST(Allocation, APlanFromAMovingStartTakesNone) {
  Scenario s = fixture::station(Id::d1, {3.0, -2.0, 0.4});
  for (const double speed : {-0.7, 0.5}) {
    s.start_motion = {speed, 0.15};
    plans_without_memory(s, Status::solved);
    Scenario pockets = fixture::with_pockets(Manoeuvre::dock);
    pockets.start_motion = {speed, 0.15};
    plans_without_memory(pockets, Status::solved);
  }
}

TEST(Allocation, NeitherDoesOneThatFindsNothing) {
  Scenario late = fixture::station(Id::d0);
  late.start = {0.9, 0.1, pi};  // before the shelf, at speed
  late.start_motion = {0.9, 0.0};
  plans_without_memory(late, Status::no_path);
  Scenario walled = fixture::station(Id::d0);
  walled.map.lines.push_back({{3.6, -7.0}, {3.6, 7.0}});
  plans_without_memory(walled, Status::no_path);
}

TEST(Allocation, NorPlansInRandomStations) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scenario scenario = generate_station(seed).value();
    const auto docking = Docking::prepare(scenario);
    ASSERT_TRUE(docking) << docking.error().message();
    counted_plan(*docking);
  }
}

TEST(Allocation, IsCounted) {
  const std::int64_t before = allocations;
  const std::vector<int> list(7);
  EXPECT_EQ(allocations - before, 1) << list.size();
}

}  // namespace
}  // namespace waywright
