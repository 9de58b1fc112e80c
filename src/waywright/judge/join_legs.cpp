#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "waywright/core/version.hpp"
#include "waywright/judge/legs.hpp"

namespace waywright {
namespace {

bool is_stopped_there(Status status) { return status != Status::solved && status != Status::unproven; }

/// +1 or −1 of the first or last sample that drives; 0 where none does.
template <class Iterator>
int driving(Iterator first, Iterator last) {
  const auto drives = std::find_if(first, last, [](const Sample& s) { return s.direction != 0; });
  return drives == last ? 0 : drives->direction;
}

Metrics joined_metrics(const std::vector<JudgedLeg>& legs) {
  Metrics all;
  all.min_clearance = legs.front().plan.metrics.min_clearance;
  double weighted = 0.0, by_samples = 0.0, samples = 0.0;
  int before = 0;
  for (const JudgedLeg& leg : legs) {
    const Metrics& m = leg.plan.metrics;
    const std::vector<Sample>& s = leg.plan.samples;
    all.length += m.length;
    all.min_clearance = std::min(all.min_clearance, m.min_clearance);
    weighted += m.length * m.mean_clearance;
    by_samples += static_cast<double>(s.size()) * m.mean_clearance;
    samples += static_cast<double>(s.size());
    all.max_curvature = std::max(all.max_curvature, m.max_curvature);
    all.max_curvature_rate = std::max(all.max_curvature_rate, m.max_curvature_rate);
    all.curvature_change += m.curvature_change;
    all.curvature_change_printed += m.curvature_change_printed;
    all.turning += m.turning;
    const int first = driving(s.begin(), s.end());
    all.direction_changes += m.direction_changes + (before * first < 0 ? 1 : 0);
    if (const int last = driving(s.rbegin(), s.rend()); last != 0) before = last;
    all.collision_risk += m.collision_risk;
    all.travel_time += m.travel_time;
  }
  all.mean_clearance = legs.size() == 1 ? legs.front().plan.metrics.mean_clearance : all.length > 0.0 ? weighted / all.length : by_samples / samples;
  return all;
}

/// @pre each leg has a path. Its tightest spot is told by `obstacle`.
Certificate joined_certificate(const std::vector<JudgedLeg>& legs, std::string& obstacle) {
  Certificate all = legs.front().plan.certificate;
  obstacle = legs.front().plan.tightest_obstacle;
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const Certificate& c = legs[i].plan.certificate;
    const double checked = all.checked_length + c.checked_length;
    const double tolerance = std::max(all.tolerance, c.tolerance);
    const bool is_free = all.collision_free && c.collision_free;
    auto pocket = all.pocket_clearance;
    if (c.pocket_clearance) pocket = std::min(*c.pocket_clearance, pocket.value_or(*c.pocket_clearance));
    // Where something touches, that is the spot to show.
    const bool is_worse = all.collision_free == c.collision_free ? c.clearance < all.clearance || (!all.tightest && c.tightest) : all.collision_free;
    const double clearance = std::min(all.clearance, c.clearance);
    if (is_worse) {
      all = c;
      obstacle = legs[i].plan.tightest_obstacle;
    }
    all.clearance = clearance;
    all.checked_length = checked;
    all.tolerance = tolerance;
    all.collision_free = is_free;
    all.pocket_clearance = pocket;
  }
  all.tightest_source = World::nothing;  // of one leg's world, and nobody's here
  return all;
}

LegResult result_of(const Scenario& mission, const JudgedLeg& leg) {
  const Plan& plan = leg.plan;
  LegResult result;
  result.name = mission.legs[leg.begin.index].name;
  result.load = leg.begin.load;
  result.planner = plan.planner;
  result.parameters = plan.parameters;
  result.status = plan.status;
  result.reason = plan.reason;
  result.start = leg.begin.pose;
  result.end = leg.end;
  result.has_path = !plan.path.pieces.empty();
  result.effort = plan.effort;
  result.metrics = plan.metrics;
  result.certificate = plan.certificate;
  result.certificate.tightest_source = World::nothing;
  result.tightest_obstacle = plan.tightest_obstacle;
  return result;
}

void append_path(Plan& all, Plan leg) {
  const std::size_t pieces = all.path.pieces.size();
  const double s = all.samples.empty() ? 0.0 : all.samples.back().s;
  const double t = all.samples.empty() ? 0.0 : all.samples.back().t;
  std::move(leg.path.pieces.begin(), leg.path.pieces.end(), std::back_inserter(all.path.pieces));
  all.samples.reserve(all.samples.size() + leg.samples.size());
  for (Sample sample : leg.samples) {
    sample.s += s;
    sample.t += t;
    sample.piece += pieces;
    all.samples.push_back(sample);
  }
}

/// "leg 3", "legs 3 and 5", "legs 3 to 5", "legs 1, 3 to 5 and 8"; counted from 1. @pre not empty, ascending
std::string words_of_legs(const std::vector<std::size_t>& legs) {
  if (legs.size() == 1) return fmt::format("leg {}", legs.front());
  std::vector<std::string> runs;
  for (std::size_t first = 0; first < legs.size();) {
    std::size_t last = first;
    while (last + 1 < legs.size() && legs[last + 1] == legs[last] + 1) ++last;
    if (last >= first + 2) runs.push_back(fmt::format("{} to {}", legs[first], legs[last]));
    else for (std::size_t i = first; i <= last; ++i) runs.push_back(fmt::format("{}", legs[i]));
    first = last + 1;
  }
  std::string text = "legs ";
  for (std::size_t i = 0; i < runs.size(); ++i) text += fmt::format("{}{}", i == 0 ? "" : i + 1 == runs.size() ? " and " : ", ", runs[i]);
  return text;
}

/// Sentences that several legs have, word for word, with the legs (counted from 1); in the order of their coming.
class SharedSentences {
 public:
  explicit SharedSentences(const std::vector<JudgedLeg>& legs) : legs_{legs.size()} {
    std::map<std::string, std::size_t> known;
    for (const JudgedLeg& leg : legs) {
      for (const std::string& sentence : leg.plan.explanation) {
        const auto [there, is_new] = known.emplace(sentence, told_.size());
        if (is_new) told_.push_back({sentence, {}});
        std::vector<std::size_t>& numbers = told_[there->second].legs;
        if (numbers.empty() || numbers.back() != leg.begin.index + 1) numbers.push_back(leg.begin.index + 1);
      }
    }
    std::erase_if(told_, [](const Told& t) { return t.legs.size() < 2; });
    for (const Told& t : told_) shared_.insert(t.sentence);
  }
  bool has(const std::string& sentence) const { return shared_.contains(sentence); }
  std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const Told& t : told_) {
      const std::string which = t.legs.size() == legs_ ? (legs_ == 2 ? "On both legs: " : "On all legs: ") : fmt::format("On {}: ", words_of_legs(t.legs));
      all.push_back(which + t.sentence);
    }
    return all;
  }

 private:
  struct Told {
    std::string sentence;
    std::vector<std::size_t> legs;
  };
  std::size_t legs_;
  std::vector<Told> told_;
  std::set<std::string> shared_;
};

void append_words(Plan& all, const Plan& leg, std::size_t index, bool is_shown, const SharedSentences& shared) {
  std::copy_if(leg.explanation.begin(), leg.explanation.end(), std::back_inserter(all.explanation), [&](const std::string& sentence) { return !shared.has(sentence); });
  for (Alternative a : leg.alternatives) {
    a.name = fmt::format("leg {}: {}", index + 1, a.name);
    a.zone.clear();
    if (!is_shown) a.poses.clear();
    all.alternatives.push_back(std::move(a));
  }
}

/// Of each load that was set down on the way: on which legs it is an obstacle, and where it is taken up again.
std::vector<std::string> sentences_of_left_loads(const Scenario& mission, const std::vector<LegBegin>& begins) {
  struct Told {
    LeftLoad load;
    std::vector<std::size_t> legs;
    std::string taken;
  };
  std::vector<Told> told;
  for (const LegBegin& begin : begins) {
    for (const LeftLoad& load : begin.left) {
      auto known = std::find_if(told.begin(), told.end(), [&](const Told& t) { return t.load.leg == load.leg; });  // a leg leaves one load at most
      if (known == told.end()) known = told.insert(told.end(), Told{load, {}, {}});
      if (is_taken_again(mission, begin.index, load)) known->taken = fmt::format("; leg {} takes it up again, and is not proven against it", begin.index + 1);
      else if (load.is_clear) known->legs.push_back(begin.index + 1);
    }
  }
  std::vector<std::string> sentences;
  for (const Told& t : told) {
    const std::string name = fmt::format("The load \"{}\", left where leg {} ends, ", t.load.name, t.load.leg + 1);
    sentences.push_back(name + (t.legs.empty() ? "is an obstacle on no later leg" : "stands there as an obstacle on " + words_of_legs(t.legs)) + t.taken + ".");
  }
  return sentences;
}

}  // namespace

std::string leg_headline(const Scenario& mission, const std::vector<LegResult>& legs, std::size_t index) {
  const LegResult& leg = legs[index];
  std::string label = leg_label(mission, index);
  label.front() = 'L';
  const std::string load = leg.load.empty() ? "without a load" : fmt::format("with the load \"{}\"", leg.load);
  if (!leg.has_path) return fmt::format("{}, {}, by {}: {}.", label, load, leg.planner, to_string(leg.status));
  const Certificate& c = leg.certificate;
  const std::string clear = !c.collision_free ? "not free of collision" : c.tightest ? fmt::format("at least {:.4f} m clear", c.clearance) : fmt::format("nothing within {:.1f} m", c.clearance);
  return fmt::format("{}, {}, by {}: {:.3f} m in {:.1f} s, {}{}.", label, load, leg.planner, leg.metrics.length, leg.metrics.travel_time, clear,
                     leg.status == Status::solved ? "" : fmt::format(" ({})", to_string(leg.status)));
}

bool tells_of_several_legs(const std::string& sentence) {
  for (const char* begin : {"On all legs: ", "On both legs: ", "On legs "}) {
    if (sentence.starts_with(begin)) return true;
  }
  return sentence.starts_with("The load \"") && sentence.find("\", left where leg ") != std::string::npos && sentence.find(" ends, ") != std::string::npos;
}

Plan join_legs(const Scenario& mission, std::vector<JudgedLeg> legs) {
  Plan all;
  all.version = version;
  all.scenario = mission;
  all.planner = mission.planner.name;
  all.parameters = mission.planner.parameters;
  all.seed = mission.seed;
  all.status = Status::solved;
  const auto has_path = [](const JudgedLeg& leg) { return !leg.plan.path.pieces.empty(); };
  const bool is_whole = legs.size() == mission.legs.size() && std::all_of(legs.begin(), legs.end(), has_path);
  const bool is_measured = is_whole && std::all_of(legs.begin(), legs.end(), [](const JudgedLeg& leg) { return !leg.plan.samples.empty(); });
  if (is_whole) all.certificate = joined_certificate(legs, all.tightest_obstacle);
  if (is_measured) all.metrics = joined_metrics(legs);
  std::vector<LegBegin> begins;
  const SharedSentences shared{legs};
  for (JudgedLeg& leg : legs) {
    begins.push_back(leg.begin);
    Plan& plan = leg.plan;
    LegResult& result = all.legs.emplace_back(result_of(mission, leg));
    // A leg without a path ends the mission there, whatever of those before it is not proven.
    if (plan.status != Status::solved && (all.status == Status::solved || is_stopped_there(plan.status))) {
      all.status = plan.status;
      all.reason = fmt::format("{}: {}", leg_label(mission, leg.begin.index), plan.reason);
    }
    all.reproducible = all.reproducible && plan.reproducible;
    all.effort.evaluations += plan.effort.evaluations;
    all.effort.expansions += plan.effort.expansions;
    all.timing.prepare += plan.timing.prepare;
    all.timing.plan += plan.timing.plan;
    all.timing.prove += plan.timing.prove;
    all.explanation.push_back(leg_headline(mission, all.legs, leg.begin.index));
    append_words(all, plan, leg.begin.index, is_stopped_there(plan.status), shared);
    if (!is_whole) {
      result.driven = std::move(plan.samples);
      continue;
    }
    result.pieces = plan.path.pieces.size();
    result.samples = is_measured ? plan.samples.size() : 0;
    if (!is_measured) plan.samples.clear();
    append_path(all, std::move(plan));
  }
  for (std::string& sentence : shared.sentences()) all.explanation.push_back(std::move(sentence));
  for (std::string& sentence : sentences_of_left_loads(mission, begins)) all.explanation.push_back(std::move(sentence));
  return all;
}

std::optional<std::vector<Plan>> parts_of(const Plan& plan) {
  std::size_t pieces = 0, samples = 0;
  for (const LegResult& leg : plan.legs) {
    // One by one, so that no sum can run over.
    if (leg.pieces == 0 || leg.pieces > plan.path.pieces.size() - pieces || leg.samples > plan.samples.size() - samples) return std::nullopt;
    pieces += leg.pieces;
    samples += leg.samples;
  }
  if (pieces != plan.path.pieces.size() || samples != plan.samples.size()) return std::nullopt;
  std::vector<Plan> parts;
  auto piece = plan.path.pieces.begin();
  auto sample = plan.samples.begin();
  for (const LegResult& leg : plan.legs) {
    Plan& part = parts.emplace_back();
    part.status = leg.status;
    part.reason = leg.reason;
    part.metrics = leg.metrics;
    part.certificate = leg.certificate;
    part.tightest_obstacle = leg.tightest_obstacle;
    part.planner = leg.planner;
    part.parameters = leg.parameters;
    part.effort = leg.effort;
    part.path.pieces.assign(piece, piece + static_cast<std::ptrdiff_t>(leg.pieces));
    part.samples.assign(sample, sample + static_cast<std::ptrdiff_t>(leg.samples));
    piece += static_cast<std::ptrdiff_t>(leg.pieces);
    sample += static_cast<std::ptrdiff_t>(leg.samples);
    if (part.samples.empty()) continue;
    const double s = part.samples.front().s, t = part.samples.front().t;
    const auto first_piece = static_cast<std::size_t>(piece - plan.path.pieces.begin()) - leg.pieces;
    for (Sample& each : part.samples) {
      each.s -= s;
      each.t -= t;
      each.piece -= std::min(each.piece, first_piece);  // of a plan that was read they are not known
    }
  }
  return parts;
}

}  // namespace waywright
