// Plans that are being driven while the shelf turns out to be elsewhere by up to 3 cm each way and 0.01 rad: random stations (seeds 1 to N)
// where a pattern serves, five times on each way. Prints the table of docs/performance.md. usage: replans [N]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/docking/docking.hpp"
#include "waywright/study/generate.hpp"

namespace {

using namespace waywright;

constexpr int times_each = 5;
constexpr double farthest = 0.03, most_turned = 0.01;  // m, rad
constexpr std::array reaches{0.5, 1.0, 2.0, 4.0, 1e9};  // m to go

struct Row {
  int all = 0, carried = 0, bent = 0, in_motion = 0, after_a_stop = 0, none = 0;
  double moved = 0.0;
  std::vector<double> ms{};
};

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

int main(int argc, char** argv) {
  const int wanted = argc > 1 ? std::max(1, std::atoi(argv[1])) : 200;
  std::array<Row, reaches.size()> rows;
  for (int seed = 1; seed <= wanted; ++seed) {
    const auto scenario = generate_station(static_cast<std::uint64_t>(seed));
    if (!scenario) return 2;
    const auto docking = Docking::prepare(*scenario);
    if (!docking) return 2;
    const DockingPlan plan = docking->plan();
    if (plan.status != Status::solved) continue;
    Random random = Random::stream(static_cast<std::uint64_t>(seed), 7);
    for (int i = 0; i < times_each; ++i) {
      const Handover at = handover_at(plan.path, plan.samples, random.uniform(0.0, 1.0) * plan.travel_time);
      Shelf shelf = std::get<Station>(scenario->mission).shelf;
      const Pose moved = Frame{make_pose(shelf.center, shelf.heading)}.to_world(
          make_pose({random.uniform(-farthest, farthest), random.uniform(-farthest, farthest)}, random.uniform(-most_turned, most_turned)));
      shelf.center = moved.position();
      shelf.heading = moved.heading;
      const auto again = docking->from(at.pose, at.motion, shelf);
      if (!again) continue;  // the shelf would leave its station
      auto session = DockingSession::on(*again);
      if (!session) return 2;
      const double begin = now();
      const DockingPlan& next = session->replan(plan, at.driven);
      const double ms = 1000.0 * (now() - begin);
      const double left = plan.length - at.driven;
      Row& row = *std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return left <= reaches[static_cast<std::size_t>(&r - rows.data())]; });
      ++row.all;
      row.ms.push_back(ms);
      if (next.status != Status::solved) ++row.none;
      else if (!next.is_carried_on) ++(next.in_motion ? row.in_motion : row.after_a_stop);
      else {
        ++(next.evaluations == 0 ? row.carried : row.bent);
        row.moved = std::max(row.moved, next.moved);
      }
    }
  }
  fmt::print("| m to go | replanned | carried along | bent beside | anew in motion | anew after a stop | no plan | moved at most, m | CPU ms, median | worst |\n"
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  double from = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Row& r = rows[i];
    std::sort(r.ms.begin(), r.ms.end());
    if (r.all > 0) {
      fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.3f} | {:.2f} | {:.2f} |\n", reaches[i] < 1e6 ? fmt::format("{}–{}", from, reaches[i]) : fmt::format("over {}", from),
                 r.all, r.carried, r.bent, r.in_motion, r.after_a_stop, r.none, r.moved, r.ms[r.ms.size() / 2], r.ms.back());
    }
    from = reaches[i];
  }
  return 0;
}
