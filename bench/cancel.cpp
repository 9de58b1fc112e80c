// How long a plan goes on after its flag was raised from another thread: sessions in random stations with endless searches, the flag raised
// after 1 to 4 ms. What was found by then is proven, sampled and timed. Prints one line of docs/performance.md. usage: cancel [N]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "waywright/docking/docking.hpp"
#include "waywright/study/generate.hpp"

int main(int argc, char** argv) {
  using namespace waywright;
  using Clock = std::chrono::steady_clock;
  const int wanted = argc > 1 ? std::max(1, std::atoi(argv[1])) : 400;
  std::vector<double> proven;        // µs from flag to answer, of plans
  std::vector<double> empty_handed;  // µs, of those that had found nothing that could be proven
  for (int i = 0; i < wanted; ++i) {
    const auto scenario = generate_station(static_cast<std::uint64_t>(1 + i % 100));
    if (!scenario) return 2;
    PatternDockingOptions endless;
    endless.evaluations = 1'000'000'000;
    const auto docking = Docking::prepare(*scenario, endless);
    if (!docking) return 2;
    auto session = DockingSession::on(*docking);
    if (!session) return 2;
    std::atomic<bool> cancel{false};
    Clock::time_point raised;
    std::thread other{[&] {
      std::this_thread::sleep_for(std::chrono::microseconds{1000 + 3000 * (i % 16) / 16});
      raised = Clock::now();
      cancel = true;
    }};
    const DockingPlan& plan = session->plan({}, &cancel);
    const Clock::time_point ended = Clock::now();
    other.join();
    if (plan.reproducible) return 1;  // it ended of itself
    const double taken = std::chrono::duration<double, std::micro>(ended - raised).count();
    (plan.status == Status::solved ? proven : empty_handed).push_back(taken);
  }
  const auto told = [](std::vector<double>& times) {
    if (times.empty()) return std::string{"none"};
    std::sort(times.begin(), times.end());
    const auto at = [&](double share) { return times[std::min(times.size() - 1, static_cast<std::size_t>(share * static_cast<double>(times.size())))]; };
    return fmt::format("median {:.0f} µs, 95 % {:.0f} µs, 99 % {:.0f} µs, worst {:.0f} µs of {}", at(0.5), at(0.95), at(0.99), at(1.0), times.size());
  };
  fmt::print("From flag to answer, wall clock, with a proven plan: {}; with none: {}.\n", told(proven), told(empty_handed));
  return 0;
}
