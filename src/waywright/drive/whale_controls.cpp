#include "waywright/drive/whale_controls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/drive/drive_model.hpp"
#include "waywright/optimizer/whale_search.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double collision_price = 10.0;  // m
constexpr std::size_t numbers = 3;        // of a triplet
constexpr int most_braking = 20'000;      // steps

/// What a candidate does, or the answer: steps of the simulation.
class Simulation {
 public:
  Simulation(const Problem& problem, const WhaleControlOptions& options, double period)
      : problem_{problem}, model_{problem.vehicle(), options.turn_speed}, clearance_{options.clearance}, period_{period}, radius_{problem.footprint().radius()} {}

  const DriveModel& model() const { return model_; }

  /// Each step is told: the state before it, what it does, its time, the state after it; a false answer ends the drive. The state is where it ended.
  template <class Told>
  double drive(DriveState& state, std::span<const double> triplets, bool to_stand, Told&& told) const {
    double all = 0.0;
    for (std::size_t k = 0; k + numbers <= triplets.size(); k += numbers) {
      double left = triplets[k + 2];
      while (left > 1e-9) {
        const double time = std::min(left, period_);
        left -= time;
        all += time;
        const DriveState before = state;
        const DriveStep step = model_.advance(state, triplets[k], triplets[k + 1], time);
        if (!told(before, step, time)) return all;
      }
    }
    for (int i = 0; to_stand && i < most_braking && !model_.stands(state); ++i) {
      const DriveState before = state;
      all += period_;
      const DriveStep step = model_.brake(state, period_);
      if (!told(before, step, period_)) return all;
    }
    return all;
  }

  double time_after(DriveState& state, std::span<const double> triplets, bool to_stand) const {
    return drive(state, triplets, to_stand, [](const DriveState&, const DriveStep&, double) { return true; });
  }

  /// The footprint is free at every step's end. A clearance that is known is used up by what the vehicle moves, and asked for anew where it is.
  bool is_free(DriveState state, std::span<const double> triplets, bool to_stand) const {
    double known = 0.0;
    bool free = true;
    const DriveState* const at = &state;
    drive(state, triplets, to_stand, [&](const DriveState&, const DriveStep& step, double time) {
      known -= reach(step, time);
      if (known > clearance_) return true;
      known = problem_.world().least_clearance(problem_.footprint(), at->pose, clearance_cap);
      return free = known > clearance_;
    });
    return free;
  }

  /// The motion of one step is free from begin to end: halved until a pose's clearance covers what any point of the footprint moves.
  bool is_free_between(const Pose& from, const DriveStep& step, double time) const {
    const Pose middle = arc_step(from, 0.5 * step.v * time, 0.5 * step.turn * time);
    const double half = 0.5 * reach(step, time);
    const double needed = half + rounding + clearance_;
    const double clear = problem_.world().least_clearance(problem_.footprint(), middle, 2.0 * needed + 1e-3);
    if (clear > needed) return true;
    if (!(clear > clearance_) || half < finest) return false;
    return is_free_between(from, step, 0.5 * time) && is_free_between(middle, step, 0.5 * time);
  }

 private:
  static constexpr double finest = 1e-5;    // m
  static constexpr double rounding = 1e-9;  // m
  double reach(const DriveStep& step, double time) const { return (std::abs(step.v) + radius_ * std::abs(step.turn)) * time; }

  const Problem& problem_;
  DriveModel model_;
  double clearance_, period_, radius_;
};

/// One segment's search, with the memory for it.
class SegmentSearch {
 public:
  SegmentSearch(const Simulation& simulation, const WhaleControlOptions& options) : simulation_{simulation}, options_{options} {}

  struct Found {
    std::vector<double> triplets;
    double cost = infinity;
    EndError end;
    bool is_free = false;
  };

  Found search(const DriveState& from, const ControlWaypoint& to, std::size_t triplets, Random random) {
    const std::size_t dimension = numbers * triplets, size = static_cast<std::size_t>(options_.population);
    set_bounds(to, triplets);
    places_.resize(size * dimension);
    best_.assign(dimension, 0.0);
    mean_.resize(options_.form == WhaleForm::unbiased ? dimension : 0);
    for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = random.uniform(low_[i % dimension], high_[i % dimension]);
    if (options_.warm) set_as_planned(to, triplets);
    WhaleAgents agents{low_, high_, places_, best_, infinity, mean_};
    const auto value = [&](std::size_t, std::span<const double> x) { return cost(from, to, x, agents.best_value); };
    for (std::size_t i = 0; i < size; ++i) agents.learn(i, value(i, agents.place(i)));
    whale_search(options_.whale, static_cast<std::size_t>(options_.iterations), agents, random, value, [](std::size_t) { return false; });
    Found found;
    found.cost = agents.best_value;
    found.triplets = best_;
    DriveState state = from;
    simulation_.time_after(state, best_, to.is_stand);
    found.end = end_error(state.pose, to.pose);
    found.is_free = is_free_throughout(from, to, best_);
    if (!found.is_free && found.cost < collision_price) found.cost += collision_price;
    return found;
  }
  std::int64_t evaluations() const { return evaluations_; }

 private:
  void set_bounds(const ControlWaypoint& to, std::size_t triplets) {
    const DriveModel& model = simulation_.model();
    const double forward = to.direction >= 0 ? std::min(model.most_speed(1), to.top_speed) : 0.0;
    const double backward = to.direction < 0 ? -std::min(model.most_speed(-1), to.top_speed) : 0.0;
    low_.clear();
    high_.clear();
    for (std::size_t k = 0; k < triplets; ++k) {
      // A turn where the vehicle stands is asked for no speed at all, but has a variable of it like any other segment.
      low_.insert(low_.end(), {to.direction == 0 ? -1e-6 : backward, -model.most_turn(), options_.least_time});
      high_.insert(high_.end(), {to.direction == 0 ? 1e-6 : forward, model.most_turn(), options_.most_time});
    }
  }

  /// The first agent: driving in equal parts, then the turn on the spot, each by its mean.
  void set_as_planned(const ControlWaypoint& to, std::size_t triplets) {
    const bool turns = to.turn_time > 0.0;
    const std::size_t parts = turns && triplets > 1 && to.way_time > 0.0 ? triplets - 1 : triplets;
    for (std::size_t k = 0; k < triplets; ++k) {
      const bool is_way = k < parts && to.way_time > 0.0;
      const double time = is_way ? to.way_time : to.turn_time;
      const double share = is_way ? 1.0 / static_cast<double>(parts) : 1.0 / static_cast<double>(to.way_time > 0.0 ? 1 : triplets);
      const double of_triplet[numbers] = {is_way ? to.way / std::max(1e-9, time) : 0.0, (is_way ? to.bend : to.turn) / std::max(1e-9, time), time * share};
      for (std::size_t i = 0; i < numbers; ++i) places_[numbers * k + i] = std::clamp(of_triplet[i], low_[numbers * k + i], high_[numbers * k + i]);
    }
  }

  double cost(const DriveState& from, const ControlWaypoint& to, std::span<const double> x, double best) {
    ++evaluations_;
    DriveState state = from;
    const double time = simulation_.time_after(state, x, to.is_stand);
    const EndError end = end_error(state.pose, to.pose);
    const double sum = end.position + options_.heading_weight * end.heading + options_.time_weight * time +
                       options_.speed_weight * std::max(0.0, std::abs(state.v) - to.speed) + options_.rate_weight * std::abs(state.turn - to.turn_rate);
    if (!(sum < best)) return sum;  // not the best, whether it collides or not
    return simulation_.is_free(from, x, to.is_stand) ? sum : sum + collision_price;
  }

  bool is_free_throughout(const DriveState& from, const ControlWaypoint& to, std::span<const double> x) const {
    bool free = true;
    DriveState state = from;
    simulation_.drive(state, x, to.is_stand,
                      [&](const DriveState& before, const DriveStep& step, double time) { return free = simulation_.is_free_between(before.pose, step, time); });
    return free;
  }

  const Simulation& simulation_;
  const WhaleControlOptions& options_;
  std::vector<double> low_, high_, places_, best_, mean_;
  std::int64_t evaluations_ = 0;
};

bool arrives(const EndError& end, const WhaleControlOptions& options) { return end.position < options.tolerance && end.heading < options.heading_tolerance; }

/// Rows and figures of segments that are settled, driven from `state` on.
void add_up(WhaleControls& controls, const Problem& problem, const Simulation& simulation, DriveState state, const WhaleControlOptions& options) {
  const Vehicle& vehicle = problem.vehicle();
  const auto steering = [&](const DriveState& at) { return vehicle.can_turn_on_the_spot() ? 0.0 : vehicle.steering_angle(at.curvature); };
  controls.collision_free = controls.arrives = true;
  double t = 0.0;
  std::vector<double> triplets;
  for (const ControlSegment& segment : controls.segments) {
    triplets.clear();
    for (const Triplet& triplet : segment.triplets) triplets.insert(triplets.end(), {triplet.v, triplet.turn, triplet.time});
    simulation.drive(state, triplets, segment.to.is_stand, [&](const DriveState& before, const DriveStep& step, double time) {
      controls.rows.push_back({t, {step.v, 0.0, step.turn}, steering(before), before.pose});
      t += time;
      return true;
    });
    controls.worst_end = std::max(controls.worst_end, segment.end.position);
    controls.collision_free = controls.collision_free && segment.collision_free;
    controls.worst_heading = std::max(controls.worst_heading, segment.end.heading);
    controls.arrives = controls.arrives && arrives(segment.end, options);
  }
  controls.rows.push_back({t, {}, steering(state), state.pose});
  controls.least_clearance = clearance_cap;
  for (const ControlRow& row : controls.rows) {
    controls.least_clearance = std::min(controls.least_clearance, problem.world().least_clearance(problem.footprint(), row.pose, controls.least_clearance));
  }
}

}  // namespace

WhaleControls whale_controls(const Problem& problem, const Plan& plan, const WhaleControlOptions& options, double period, std::uint64_t seed) {
  WhaleControls controls;
  controls.period = period;
  const std::vector<ControlWaypoint> waypoints = control_waypoints(problem, plan, options.spacing);
  if (plan.samples.empty()) return controls;
  const Simulation simulation{problem, options, period};
  SegmentSearch search{simulation, options};
  const Sample& first = plan.samples.front();
  const double body_curvature = first.direction * first.curvature;
  const DriveState state{first.pose(), first.direction * first.speed, body_curvature * first.direction * first.speed, body_curvature};
  const auto serves = [&](const SegmentSearch::Found& f) {
    return f.is_free && f.end.position < std::min(options.aim, options.tolerance) && f.end.heading < std::min(options.heading_aim, options.heading_tolerance);
  };
  // What arrives goes before what is cheaper.
  const auto rank = [&](const SegmentSearch::Found& f) { return (f.is_free ? 0 : 2) + (arrives(f.end, options) ? 0 : 1); };
  std::uint64_t searches = 0;
  std::vector<DriveState> begins{state};
  std::vector<std::size_t> failures(waypoints.size(), 0);
  std::int64_t steps_back = 0;
  while (controls.segments.size() < waypoints.size()) {
    const std::size_t index = controls.segments.size();
    ControlSegment segment;
    segment.to = waypoints[index];
    SegmentSearch::Found best;
    const std::int64_t before = search.evaluations();
    for (std::int64_t n = options.triplets; n <= std::max(options.triplets, options.most_triplets) && !serves(best); ++n) {
      for (std::int64_t attempt = 0; attempt <= options.restarts && !serves(best); ++attempt) {
        auto found = search.search(begins[index], segment.to, static_cast<std::size_t>(n), Random::stream(seed, searches++));
        ++segment.searches;
        if (best.triplets.empty() || rank(found) < rank(best) || (rank(found) == rank(best) && found.cost < best.cost)) best = std::move(found);
      }
    }
    if (rank(best) > 0 && index > 0 && steps_back < options.backtracks) {
      // It begins where nothing leads on from: the segments before it are driven otherwise, more of them each time.
      ++steps_back;
      const std::size_t kept = index - std::min(index, ++failures[index]);
      controls.segments.resize(kept);
      begins.resize(kept + 1);
      continue;
    }
    segment.evaluations = search.evaluations() - before;
    for (std::size_t k = 0; k + numbers <= best.triplets.size(); k += numbers) segment.triplets.push_back({best.triplets[k], best.triplets[k + 1], best.triplets[k + 2]});
    segment.end = best.end;
    segment.collision_free = best.is_free;
    DriveState end = begins[index];
    segment.time = simulation.time_after(end, best.triplets, segment.to.is_stand);
    begins.push_back(end);
    controls.segments.push_back(std::move(segment));
  }
  controls.evaluations = search.evaluations();
  add_up(controls, problem, simulation, state, options);
  controls.end = end_error(controls.rows.back().pose, plan.samples.back().pose());
  return controls;
}

}  // namespace waywright
