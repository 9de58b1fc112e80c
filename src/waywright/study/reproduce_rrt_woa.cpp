#include "waywright/study/reproduce_rrt_woa.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/threads.hpp"
#include "waywright/planner/tree/plane_tree.hpp"
#include "waywright/planner/tree/whale_refinement.hpp"
#include "waywright/planner/tree/whale_steering.hpp"
#include "waywright/study/rrt_woa_tables.hpp"

namespace waywright::rrt_woa {
namespace {

constexpr std::size_t maps = 5;
constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
/// Of the publication's configuration file.
constexpr PlaneTreeOptions tree_options{.samples = 10'000, .step = 1.0, .radius = 1.5, .goal_threshold = 1.0, .first_path = true, .straight_first = false};

Problem of_a_point(const WhaleMap& map) {
  Scenario s;
  s.map = map.map;
  s.vehicle.footprint = {{}, 0.0};
  s.vehicle.drive = Differential{0.5};
  s.start = make_pose(map.task.start, 0.0);
  s.mission = make_pose(map.task.goal, 0.0);
  return Problem::prepare(std::move(s)).value();
}

struct Settings {
  int population = 10, iterations = 10;
  WhaleParameters whale;
};

Settings settings_of(const Table& table, const Row& row) {
  Settings s;
  s.whale.start = row.start;
  if (table.parameter == "population") s.population = static_cast<int>(row.value);
  if (table.parameter == "iterations") s.iterations = static_cast<int>(row.value);
  if (table.parameter == "mu") s.whale.choice = row.value;
  if (table.parameter == "b") s.whale.spiral = row.value;
  if (table.parameter == "lambda") s.whale.threshold = row.value;
  return s;
}

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// One map and seed: a first path of RRT*, and what both variants make of it.
class Trial {
 public:
  Trial(const PlaneSpace& space, std::uint64_t seed) : space_{space}, start_{space.problem().start().position()}, goal_{{space.problem().goal().position()}}, seed_{seed} {
    star_ = grown(nullptr);
    way_ = tree_.way();
  }

  const Outcome& star() const { return star_; }
  bool is_found() const { return way_.size() > 1; }

  Outcome local(const Settings& s) {
    WhaleSteering steering{space_, {.population = s.population, .iterations = s.iterations, .whale = s.whale}};
    return grown(&steering);
  }
  Outcome global(const Settings& s) {
    Budget budget;
    const Clock clock;
    const double metres = length_of_way(refinement_.refined(way_, space_, {.population = s.population, .iterations = s.iterations, .whale = s.whale}, seed_, budget));
    return {star_.seconds + clock.seconds(), metres, star_.nodes};
  }

 private:
  Outcome grown(TreeSteering* steering) {
    Budget budget;
    const Clock clock;
    tree_.grow(space_, tree_options, start_, goal_, seed_, budget, no_limit, steering);
    return {clock.seconds(), tree_.length(), static_cast<double>(tree_.size())};
  }

  const PlaneSpace& space_;
  Vec2 start_;
  PlaneTarget goal_;
  std::uint64_t seed_;
  PlaneTree tree_;
  WhaleRefinement refinement_;
  Outcome star_;
  std::vector<Vec2> way_;
};

Mean mean_of(const std::vector<double>& values) {
  Mean mean;
  if (values.empty()) return mean;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) mean.value += v / n;
  double squares = 0.0;
  for (const double v : values) squares += (v - mean.value) * (v - mean.value);
  if (values.size() > 1) mean.half_width = 1.96 * std::sqrt(squares / (n - 1.0) / n);
  return mean;
}

/// Outcomes by map and seed.
using Outcomes = std::vector<std::array<Outcome, maps>>;

Measured measured(const Outcomes& outcomes, const Outcomes& star, const std::array<double, maps>& shortest, const std::vector<bool>& is_done, std::optional<std::size_t> only = {}) {
  std::vector<double> seconds, metres, nodes, share;
  for (std::size_t s = 0; s < outcomes.size(); ++s) {
    if (!is_done[s]) continue;
    Outcome sum;
    double saved = 0.0, possible = 0.0;
    const std::size_t from = only.value_or(0), to = only ? *only + 1 : maps;
    for (std::size_t m = from; m < to; ++m) {
      sum.seconds += outcomes[s][m].seconds;
      sum.metres += outcomes[s][m].metres;
      sum.nodes += outcomes[s][m].nodes;
      saved += star[s][m].metres - outcomes[s][m].metres;
      possible += star[s][m].metres - shortest[m];
    }
    const auto count = static_cast<double>(to - from);
    seconds.push_back(sum.seconds / count);
    metres.push_back(sum.metres / count);
    nodes.push_back(sum.nodes / count);
    share.push_back(saved / possible);
  }
  return {mean_of(seconds), mean_of(metres), mean_of(nodes), mean_of(share), metres, nodes};
}

}  // namespace

Results run(int runs, const std::atomic<bool>* cancel) {
  Results results;
  results.comparison = published_comparison();
  results.tables = published_tables();
  std::vector<Problem> problems;
  for (const std::string& name : whale_map_names()) problems.push_back(of_a_point(*whale_map(name)));
  std::vector<std::unique_ptr<PlaneSpace>> spaces;
  for (std::size_t m = 0; m < maps; ++m) {
    spaces.push_back(std::make_unique<PlaneSpace>(problems[m]));
    Budget budget;
    results.shortest[m] = least_length(*spaces.back(), budget).metres;
  }
  // Row after row of the comparison and of all tables.
  std::vector<std::pair<Variant, Settings>> rows{{Variant::rrt_star, {}}, {Variant::local, {}}, {Variant::global, {}}};
  for (auto& [variant, settings] : rows) settings.whale.start = 4.0;
  for (const Table& table : results.tables) {
    for (const Row& row : table.rows) rows.emplace_back(table.variant, settings_of(table, row));
  }
  const auto seeds = static_cast<std::size_t>(runs);
  std::vector<Outcomes> all(rows.size(), Outcomes(seeds));
  std::vector<std::array<bool, maps>> finished(seeds, std::array<bool, maps>{});
  std::atomic<std::size_t> next{0};
  on_threads(0, seeds * maps, [&] {
    for (std::size_t job = next++; job < seeds * maps && !(cancel != nullptr && cancel->load()); job = next++) {
      const std::size_t seed = job / maps, m = job % maps;
      Trial trial{*spaces[m], seed + 1};
      if (!trial.is_found()) continue;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto& [variant, settings] = rows[r];
        all[r][seed][m] = variant == Variant::rrt_star ? trial.star() : variant == Variant::local ? trial.local(settings) : trial.global(settings);
      }
      finished[seed][m] = true;
    }
  });
  std::vector<bool> is_done(seeds);
  for (std::size_t s = 0; s < seeds; ++s) {
    is_done[s] = std::all_of(finished[s].begin(), finished[s].end(), [](bool b) { return b; });
    for (std::size_t r = 0; r < rows.size() && is_done[s]; ++r) {
      for (const Outcome& o : all[r][s]) is_done[s] = is_done[s] && std::isfinite(o.metres);  // a local search that found nothing within its samples
    }
    results.runs += is_done[s] ? 1 : 0;
  }
  std::size_t r = 0;
  for (std::size_t v = 0; v < results.comparison.size(); ++v, ++r) {
    results.comparison[v].ours = measured(all[r], all[0], results.shortest, is_done);
    for (std::size_t m = 0; m < maps; ++m) results.by_map[m][v] = measured(all[r], all[0], results.shortest, is_done, m);
  }
  for (Table& table : results.tables) {
    for (Row& row : table.rows) row.ours = measured(all[r++], all[0], results.shortest, is_done);
  }
  return results;
}

}  // namespace waywright::rrt_woa
