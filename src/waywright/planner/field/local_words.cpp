#include "waywright/planner/field/local_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/proof/moving_clearance.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::place;

constexpr double left_over = 0.15;     // m from the way: it was left
constexpr double back_under = 0.05;    // m: it is back
constexpr double told_within = 3.0;    // m: obstacles that never come nearer are not told
constexpr std::size_t most_told = 8;
constexpr double far = 10.0;           // m

std::string who(const Movers& movers, std::size_t i) { return one_line(title_of(movers.obstacle(i), i)); }

struct Left {
  double from = 0.0, until = 0.0, off = 0.0;
  std::size_t because = LocalField::nobody;
};

std::vector<Left> times_left(const LocalDrive& drive) {
  std::vector<Left> all;
  bool is_off = false;
  std::size_t because = LocalField::nobody;
  for (const LocalDriven& d : drive.driven) {
    if (d.off < back_under) {
      is_off = false;
      because = LocalField::nobody;
    }
    const std::size_t by = d.kept_by != LocalField::nobody ? d.kept_by : d.pushed_by;
    if (because == LocalField::nobody) because = by;
    if (!is_off && d.off > left_over) {
      is_off = true;
      all.push_back({d.before.t, d.before.t, d.off, because});
    }
    if (!is_off) continue;
    all.back().until = d.step.after.t;
    all.back().off = std::max(all.back().off, d.off);
    if (all.back().because == LocalField::nobody) all.back().because = by;
  }
  return all;
}

}  // namespace

std::string local_end_sentence(const LocalDrive& drive, const Movers& movers) {
  const std::string where = fmt::format("{:.1f} s after the start, at {}", drive.last.t, place(drive.last.at));
  const std::string tried = drive.tries > 0 ? fmt::format(", and {} from earlier moments, held back or on the other side, came no farther", counted(drive.tries, "new beginning")) : std::string{};
  const bool is_known = drive.obstacle != LocalField::nobody;
  switch (drive.ended) {
    case LocalEnd::met:
      return is_known ? fmt::format("{} comes too near to the vehicle {}, whichever way it gives{}", who(movers, drive.obstacle), where, tried) : fmt::format("the vehicle cannot stop before what stands {}{}", where, tried);
    case LocalEnd::taken:
      return fmt::format("{} stands at the goal for good from {:.1f} s after the start on, too near for {}, which cannot be there before", who(movers, drive.obstacle),
                         movers.obstacle(drive.obstacle).stands_from().value_or(0.0), "the disc around the vehicle");
    case LocalEnd::stuck: return fmt::format("the vehicle gets no farther {}{}", where, is_known ? ", because of " + who(movers, drive.obstacle) : std::string{});
    case LocalEnd::thrown_about: return fmt::format("the vehicle is thrown to and fro {}{}", where, is_known ? ", because of " + who(movers, drive.obstacle) : std::string{});
    default: return fmt::format("the {} that it may make were over {}", counted(drive.steps, "step"), where);
  }
}

std::vector<std::string> local_words(const PlaneSpace& space, const LocalDrive& drive, const Movers& movers, const FreeMotion& motion, const std::vector<Sample>& samples) {
  std::vector<std::string> text;
  double farthest = 0.0;
  for (const LocalDriven& d : drive.driven) farthest = std::max(farthest, d.off);
  const std::vector<Left> left = times_left(drive);
  std::string sentence = fmt::format("Followed under the local field in {} (up to {:g} m/s): at most {:.2f} m beside the way", counted(static_cast<std::int64_t>(drive.driven.size()), "motion"), motion.top_speed(), farthest);
  if (left.empty()) {
    sentence += fmt::format(", never more than {:g} m.", left_over);
  } else {
    sentence += fmt::format("; it was left {} by more than {:g} m:", left.size() == 1 ? std::string{"once"} : fmt::format("{} times", left.size()), left_over);
    for (std::size_t i = 0; i < std::min(left.size(), most_told); ++i) {
      const Left& l = left[i];
      sentence += fmt::format("{} {} from {:.1f} to {:.1f} s, by {:.2f} m", i == 0 ? "" : ",", l.because == LocalField::nobody ? std::string{"to cut a corner"} : "for " + who(movers, l.because), l.from, l.until, l.off);
    }
    sentence += left.size() > most_told ? ", and so on." : ".";
  }
  text.push_back(std::move(sentence));
  for (const LocalReplan& replan : drive.replans) {
    text.push_back(fmt::format("{:.1f} s after the start, at {}, the way was planned anew: {}.", replan.t, place(replan.at),
                               replan.blocked_by == LocalField::nobody ? std::string{"the old one led no farther from there"} : who(movers, replan.blocked_by) + " stands in the way, and counts as an obstacle that stays"));
  }
  if (drive.tries > 0) {
    text.push_back(fmt::format("The field alone would have been met: the drive was begun again {} from some seconds before, and is held back {} and sent past the other side {}.",
                               drive.tries == 1 ? std::string{"once"} : fmt::format("{} times", drive.tries), counted(drive.holds, "time"), counted(drive.sides, "time")));
  }
  if (samples.empty()) return text;
  struct Approach {
    std::size_t obstacle;
    double distance, t;
  };
  std::vector<Approach> all;
  const MovingClearance clearance{space.problem(), 0.0, 0.0};
  for (std::size_t i = 0; i < movers.size(); ++i) {
    Approach nearest{i, far, 0.0};
    const auto look = [&](const Pose& pose, double t) {
      if (const double d = clearance.distance_at(pose, i, t, nearest.distance); d < nearest.distance) nearest = {i, d, t};
    };
    for (std::size_t k = 0; k < samples.size(); ++k) {
      look(samples[k].pose(), samples[k].t);
      // While it stands, and on long steps, in between.
      const double until = k + 1 < samples.size() ? samples[k + 1].t : samples[k].t;
      if (k + 1 < samples.size() && samples[k + 1].pose() == samples[k].pose()) {
        for (double t = samples[k].t + 0.1; t < until; t += 0.1) look(samples[k].pose(), t);
      }
    }
    if (nearest.distance < told_within) all.push_back(nearest);
  }
  std::sort(all.begin(), all.end(), [](const Approach& a, const Approach& b) { return a.distance < b.distance; });
  if (all.empty()) {
    text.push_back(fmt::format("Nothing that moves came nearer to it than {:g} m.", told_within));
  } else {
    std::string near = "Nearest to what moves:";
    for (std::size_t i = 0; i < std::min(all.size(), most_told); ++i) near += fmt::format("{} {:.2f} m from {} after {:.1f} s", i == 0 ? "" : ",", all[i].distance, who(movers, all[i].obstacle), all[i].t);
    text.push_back(near + (all.size() > most_told ? ", and others farther off." : "."));
  }
  return text;
}

}  // namespace waywright
