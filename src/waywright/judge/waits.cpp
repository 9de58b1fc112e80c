#include "waywright/judge/waits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "waywright/proof/moving_clearance.hpp"

namespace waywright {
namespace {

constexpr double least_progress = 0.1;   // m, between two waits
constexpr double next_moment = 1e-3;     // s, after which an obstacle is looked at again
constexpr std::int64_t most_work = 100'000'000;  // samples of profiles times obstacles, in all

class Schedule {
 public:
  Schedule(const Problem& problem, const std::vector<Sample>& samples, const LimitsAlong& along, double tolerance, const std::atomic<bool>* cancel)
      : problem_{problem}, moving_{problem.scenario().moving}, samples_{samples}, along_{along}, clearance_{problem, problem.required_clearance(), tolerance}, cancel_{cancel} {
    bound_by_fastest();
    spans_.resize(moving_.size());
    for (auto& of_one : spans_) of_one.resize(samples.size() - 1);
    ends_.assign(samples.size(), samples.size() - 1);
    for (std::size_t i = samples.size() - 1; i-- > 0;) ends_[i] = is_direction_change(samples[i], samples[i + 1]) ? i : ends_[i + 1];
  }

  Timed run(std::span<const WantedWait> wanted) {
    const auto& motion = problem_.motion();
    speed_ = motion ? motion->speed : 0.0;
    std::size_t next = 0;
    const std::size_t last = samples_.size() - 1;
    while (from_ < last && may_go_on()) {
      while (next < wanted.size() && index_of(wanted[next].s) < from_) ++next;
      const bool is_wanted = next < wanted.size();
      const std::size_t to = is_wanted ? std::max(from_, index_of(wanted[next].s)) : last;
      std::vector<Sample> part = profile(from_, to, speed_);
      const auto conflict = first_conflict(part, from_, time_, true);
      if (!conflict) {
        append(part);
        if (!is_wanted) return std::move(timed_);
        const double until = std::max(time_, wanted[next].until);
        if (const auto met = meets_standing(from_, time_, until)) return hindered({Hindrance::Kind::comes, met->obstacle, samples_[from_].s, time_, 0.0, 0.0});
        wait(wanted[next].obstacle, until, 0.0, true);
        ++next;
        continue;
      }
      last_obstacle_ = conflict->obstacle;
      if (!stop_for(*conflict, to)) return hindered(hindrance_);
    }
    if (from_ < last) return hindered({Hindrance::Kind::stands, last_obstacle_, samples_[from_].s, time_, 0.0, 0.0});
    return std::move(timed_);
  }

 private:
  struct Conflict {
    std::size_t step, obstacle, at;  // the step that is driven then, and the one of the way ahead that is not clear
    TimeSpan span;
  };

  /// Work is bounded; where the bound is met the vehicle counts as hindered.
  bool may_go_on() const { return work_ < most_work && (cancel_ == nullptr || !cancel_->load(std::memory_order_relaxed)); }

  std::size_t index_of(double s) const {
    const auto found = std::lower_bound(samples_.begin(), samples_.end(), s - 1e-9, [](const Sample& a, double value) { return a.s < value; });
    return static_cast<std::size_t>(std::min(found, samples_.end() - 1) - samples_.begin());
  }

  /// Samples from `from` to `to` with times from 0 on; at rest at the end.
  std::vector<Sample> profile(std::size_t from, std::size_t to, double speed) {
    work_ += static_cast<std::int64_t>((to - from + 1) * moving_.size());
    std::vector<Sample> part{samples_.begin() + static_cast<std::ptrdiff_t>(from), samples_.begin() + static_cast<std::ptrdiff_t>(to) + 1};
    if (part.size() == 1) {
      part.front().t = part.front().speed = 0.0;
      return part;
    }
    assign_speed(part, problem_.vehicle(), speed, workspace_, limits(from, to));
    return part;
  }
  /// No part is anywhere faster than the fastest profile of the whole: under a limit of angular acceleration one that begins from rest in the middle might be, for a moment, and
  /// `verify` takes that profile for the bound.
  void bound_by_fastest() {
    std::vector<Sample> fastest = samples_;
    const auto& motion = problem_.motion();
    assign_speed(fastest, problem_.vehicle(), motion ? motion->speed : 0.0, workspace_, along_);
    if (along_.steps.empty()) {
      along_.steps.assign(samples_.size() - 1, std::numeric_limits<double>::infinity());
      along_.samples.assign(samples_.size(), std::numeric_limits<double>::infinity());
    }
    // A start in motion is as fast as it is.
    constexpr double more_than_rounding = 1.0 + 1e-12;  // so that the same profile is the same to the last bit
    for (std::size_t i = 1; i < samples_.size(); ++i) along_.samples[i] = std::min(along_.samples[i], more_than_rounding * fastest[i].speed);
  }
  LimitsAlong limits(std::size_t from, std::size_t to) const {
    LimitsAlong part;
    const auto at = [](const std::vector<double>& values, std::size_t a, std::size_t b) {
      return std::vector<double>{values.begin() + static_cast<std::ptrdiff_t>(a), values.begin() + static_cast<std::ptrdiff_t>(b)};
    };
    part.steps = at(along_.steps, from, to);
    part.samples = at(along_.samples, from, to + 1);
    return part;
  }
  bool can_stop_at(std::size_t at) {
    if (speed_ == 0.0) return true;
    if (at == from_) return false;
    const std::vector<Sample> part{samples_.begin() + static_cast<std::ptrdiff_t>(from_), samples_.begin() + static_cast<std::ptrdiff_t>(at) + 1};
    return can_start_with(part, problem_.vehicle(), speed_, workspace_, limits(from_, at));
  }
  std::size_t earliest_stop(std::size_t latest) {
    std::size_t low = from_, high = latest;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (can_stop_at(middle)) high = middle;
      else low = middle + 1;
    }
    return high;
  }

  const std::vector<TimeSpan>& spans(std::size_t obstacle, std::size_t step) {
    auto& known = spans_[obstacle][step];
    if (!known) {
      known.emplace();
      clearance_.blocked(samples_[step].pose(), samples_[step + 1].pose(), obstacle, 0.0, MovingClearance::for_ever, *known);
    }
    return *known;
  }
  /// The first span that meets [begin, end].
  const TimeSpan* meeting(std::size_t obstacle, std::size_t step, double begin, double end) {
    for (const TimeSpan& span : spans(obstacle, step)) {
      if (span.begin > end) break;
      if (span.end >= begin) return &span;
    }
    return nullptr;
  }
  bool stands_on(std::size_t step) const {
    const Sample &a = samples_[step], &b = samples_[step + 1];
    return a.pose() == b.pose();
  }
  /// One past the last step of the way that is looked at on the step from a sample on.
  std::size_t looked_at(std::size_t from, double range) const {
    std::size_t end = from;
    const double until = samples_[std::min(from + 1, samples_.size() - 1)].s + range;  // at the step's end, too
    while (end < ends_[from] && (end == from || samples_[end].s < until)) ++end;
    return std::max(end, std::min(from + 1, samples_.size() - 1));
  }

  std::optional<Conflict> first_conflict(const std::vector<Sample>& part, std::size_t from, double time, bool looks_ahead) {
    for (std::size_t k = 0; k + 1 < part.size(); ++k) {
      const double begin = time + part[k].t, end = time + part[k + 1].t;
      for (std::size_t o = 0; o < moving_.size(); ++o) {
        const std::size_t until = looks_ahead && !stands_on(from + k) ? looked_at(from + k, moving_[o].range) : from + k + 1;
        for (std::size_t at = from + k; at < until; ++at) {
          if (const TimeSpan* span = meeting(o, at, begin, end)) return Conflict{from + k, o, at, *span};
        }
      }
    }
    return std::nullopt;
  }
  struct Met {
    std::size_t obstacle;
    double t;
  };
  /// Who comes too near to the vehicle while it stands?
  std::optional<Met> meets_standing(std::size_t at, double begin, double end) {
    std::optional<Met> first;
    std::vector<TimeSpan> found;
    const Pose pose = samples_[at].pose();
    for (std::size_t o = 0; o < moving_.size(); ++o) {
      clearance_.blocked(pose, pose, o, begin, end, found);
      if (!found.empty() && (!first || found.front().begin < first->t)) first = Met{o, found.front().begin};
    }
    return first;
  }

  /// When the vehicle that has stood at `at` since `since` goes on to `to`. Empty: never, and `hindrance_` says why.
  std::optional<double> release(std::size_t at, double since, const Conflict& conflict, std::size_t to) {
    double time = since;
    std::size_t obstacle = conflict.obstacle;
    const auto never = [&](Hindrance::Kind kind, std::size_t who) {
      hindrance_ = {kind, who, samples_[at].s, since, std::max(0.0, samples_[conflict.at].s - samples_[at].s), 0.0};
      return std::nullopt;
    };
    while (may_go_on()) {
      if (const auto met = meets_standing(at, since, time)) return never(Hindrance::Kind::comes, met->obstacle);
      double later = time;
      for (std::size_t o = 0; o < moving_.size(); ++o) {
        const std::size_t until = looked_at(at, moving_[o].range);
        for (std::size_t step = at; step < until; ++step) {
          for (const TimeSpan& span : spans(o, step)) {
            if (span.begin > later || span.end + moving_[o].free_for <= later) continue;
            later = span.end + moving_[o].free_for;
            obstacle = o;
          }
        }
      }
      if (std::isinf(later)) return never(Hindrance::Kind::stands, obstacle);
      if (later > time) {
        time = later + next_moment;
        continue;
      }
      const std::vector<Sample> part = profile(at, to, 0.0);
      const auto next = first_conflict(part, at, time, true);
      if (!next || reaches_somewhere(at, time, *next)) return time;
      obstacle = next->obstacle;
      if (std::isinf(next->span.end)) return never(Hindrance::Kind::stands, obstacle);
      time = std::max(time, next->span.end + moving_[obstacle].free_for) + next_moment;
    }
    return never(Hindrance::Kind::stands, obstacle);
  }
  /// Is there a place before the conflict, some way on, where the vehicle can stand until it is over?
  bool reaches_somewhere(std::size_t from, double time, const Conflict& conflict) {
    std::size_t at = conflict.step;
    while (at > from && samples_[at].s >= samples_[from].s + least_progress && may_go_on()) {
      const std::vector<Sample> part = profile(from, at, 0.0);
      const auto again = first_conflict(part, from, time, true);
      if (!again) return !meets_standing(at, time + part.back().t, std::isinf(conflict.span.end) ? time + part.back().t : conflict.span.end);
      at = std::min(at - 1, again->step);
    }
    return false;
  }

  /// Drives on to where it can wait for the obstacle, and waits. False: hindered.
  bool stop_for(const Conflict& conflict, std::size_t to) {
    const std::size_t earliest = earliest_stop(to);
    if (speed_ > 0.0 && !can_stop_at(earliest)) {
      hindrance_ = {Hindrance::Kind::cannot_stop, conflict.obstacle, samples_[to].s, time_, samples_[conflict.at].s - samples_[from_].s, samples_[to].s - samples_[from_].s};
      return false;
    }
    std::optional<Hindrance> why;
    std::size_t at = conflict.step;
    while (at >= earliest && may_go_on()) {
      const std::vector<Sample> part = profile(from_, at, speed_);
      if (const auto again = first_conflict(part, from_, time_, true)) {
        if (at == 0) break;
        at = std::min(at - 1, again->step);
        continue;
      }
      if (try_to_wait(part, at, conflict, to, why)) return true;
      if ((why && why->kind == Hindrance::Kind::stands) || at == 0) break;
      --at;
    }
    if (why && why->kind == Hindrance::Kind::stands) {
      hindrance_ = *why;
      return false;
    }
    // Nearer than it should be: as early as it can stand.
    const std::vector<Sample> part = profile(from_, earliest, speed_);
    const double braking = samples_[earliest].s - samples_[from_].s;
    if (const auto hit = first_conflict(part, from_, time_, false)) {
      hindrance_ = {braking > 0.0 ? Hindrance::Kind::cannot_stop : Hindrance::Kind::comes, hit->obstacle, samples_[earliest].s, time_ + part.back().t, samples_[hit->at].s - samples_[from_].s, braking};
      return false;
    }
    if (try_to_wait(part, earliest, conflict, to, why)) return true;
    if (why) hindrance_ = *why;
    hindrance_.braking = braking;
    return false;
  }
  bool try_to_wait(const std::vector<Sample>& part, std::size_t at, const Conflict& conflict, std::size_t to, std::optional<Hindrance>& why) {
    const double since = time_ + part.back().t;
    const auto until = release(at, since, conflict, to);
    if (!until) {
      // What stands in the way is told of the place farthest on.
      if (!why) why = hindrance_;
      return false;
    }
    if (*until == since && at == from_) {  // nothing gained
      if (!why) why = Hindrance{Hindrance::Kind::comes, conflict.obstacle, samples_[at].s, since, 0.0, 0.0};
      return false;
    }
    append(part);
    wait(conflict.obstacle, *until, samples_[conflict.at].s - samples_[at].s, false);
    return true;
  }

  void append(const std::vector<Sample>& part) {
    const std::size_t skip = timed_.samples.empty() || timed_.samples.back().t < time_ ? 0 : 1;
    for (std::size_t i = skip; i < part.size(); ++i) {
      timed_.samples.push_back(part[i]);
      timed_.samples.back().t += time_;
    }
    time_ += part.back().t;
    from_ += part.size() - 1;
    speed_ = 0.0;
  }
  void wait(std::size_t obstacle, double until, double ahead, bool stays) {
    if (until > time_) timed_.waits.push_back({samples_[from_].s, samples_[from_].pose(), time_, until, obstacle, std::max(0.0, ahead), stays});
    time_ = until;
  }
  Timed hindered(const Hindrance& hindrance) {
    Timed fastest;
    fastest.samples = profile(0, samples_.size() - 1, problem_.motion() ? problem_.motion()->speed : 0.0);
    fastest.hindrance = hindrance;
    return fastest;
  }

  const Problem& problem_;
  const std::vector<MovingObstacle>& moving_;
  const std::vector<Sample>& samples_;
  LimitsAlong along_;
  MovingClearance clearance_;
  SpeedWorkspace workspace_;
  std::vector<std::vector<std::optional<std::vector<TimeSpan>>>> spans_;  // by obstacle and step
  std::vector<std::size_t> ends_;  // of each sample, the last one that is driven to in its direction
  Timed timed_;
  Hindrance hindrance_;
  std::size_t from_ = 0, last_obstacle_ = 0;
  double time_ = 0.0, speed_ = 0.0;
  const std::atomic<bool>* cancel_;
  std::int64_t work_ = 0;
};

}  // namespace

Timed timed_past_moving(const Problem& problem, const std::vector<Sample>& samples, const LimitsAlong& along, double tolerance, std::span<const WantedWait> wanted,
                        const std::atomic<bool>* cancel) {
  if (samples.size() < 2) return {samples, {}, {}};
  if (is_too_much_in_time(problem, samples.size())) {  // check_in_time says so
    Timed fastest{samples, {}, {}};
    SpeedWorkspace workspace;
    assign_speed(fastest.samples, problem.vehicle(), problem.motion() ? problem.motion()->speed : 0.0, workspace, along);
    return fastest;
  }
  return Schedule{problem, samples, along, tolerance, cancel}.run(wanted);
}

std::string hindrance_sentence(const Problem& problem, const Hindrance& h) {
  const std::string who = one_line(title_of(problem.scenario().moving[h.obstacle], h.obstacle));
  switch (h.kind) {
    case Hindrance::Kind::cannot_stop:
      return fmt::format("the vehicle needs {:.2f} m to come to rest, and {} is in its way {:.2f} m ahead before it could", h.braking, who, h.ahead);
    case Hindrance::Kind::comes:
      return fmt::format("{} comes to where the vehicle stands from {:.2f} s after the start on, at s = {:.2f} m, and nowhere before can it wait for it", who, h.from, h.s);
    case Hindrance::Kind::stands:
      return fmt::format("{} stands in the way for good, {:.2f} m ahead of where the vehicle comes to stand {:.2f} s after the start, at s = {:.2f} m", who, h.ahead, h.from, h.s);
  }
  return {};
}

}  // namespace waywright
