// Searches for a footprint with a shape: a state is a cell and one of as many headings as there are moves. From it the vehicle drives on to the next
// cell in its heading's direction, or back, or turns on the spot to the heading beside; each is tested against the exact outlines when the
// search comes there, unless a distance transform settles it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/grid_search.hpp"
#include "waywright/planner/grid/grid_zones.hpp"
#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {

struct HeadingCosts {
  double turn = 0.05;    ///< m for a radian of turning on the spot, ≥ 0
  double reverse = 3.0;  ///< m for a metre backwards, ≥ 1; 0: never backwards
};

/// Immutable once made; safe to read from many threads.
class HeadingSpace {
 public:
  static constexpr std::int64_t most_states = 1LL << 27;  ///< 1 GiB of records

  HeadingSpace(const Problem& problem, const GridFrame& frame, const CellBounds& bounds, Neighbours neighbours, const HeadingCosts& costs, GridZones zones = {});

  int headings() const { return headings_; }
  double angle(int heading) const { return angles_[static_cast<std::size_t>(heading)]; }  ///< rad, world frame
  int move(int heading) const { return heading * steps_of(neighbours_); }
  /// By how much a turn from a heading to the next one turns, rad; negative to the right.
  double turn(int heading) const { return turns_[static_cast<std::size_t>(heading)]; }
  int beside(int heading, int by) const { return (heading + by + headings_) % headings_; }
  bool is_drive_free(Cell from, int heading, bool backwards, MotionCheck& test) const;
  /// What a metre of this drive costs by zones, on the average.
  double factor(Cell from, int heading, bool backwards) const { return zones_.weighs() ? zones_.factor(index_of(from), moved(heading, backwards)) : 1.0; }
  const GridZones& zones() const { return zones_; }
  bool is_turn_free(Cell at, int heading, MotionCheck& test) const;  ///< between this heading and the next

  const GridFrame& frame() const { return frame_; }
  Neighbours neighbours() const { return neighbours_; }
  const HeadingCosts& costs() const { return costs_; }

 private:
  std::size_t index_of(Cell c) const { return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(frame_.columns) + static_cast<std::size_t>(c.column); }
  int moved(int heading, bool backwards) const { return backwards ? opposite(move(heading)) : move(heading); }

  const GridFrame& frame_;
  const CellBounds& bounds_;
  Neighbours neighbours_;
  HeadingCosts costs_;
  GridZones zones_;
  int headings_;
  double margin_ = 0.0;         ///< m
  double outer_ = 0.0;          ///< m, of the footprint about its origin
  double inner_ = 0.0;          ///< m, radius of a disc about the origin inside the footprint
  std::vector<double> angles_, turns_;
  std::vector<std::vector<MotionCheck::Swept>> forwards_, backwards_, turning_;
};

struct HeadingState {
  Cell cell{};
  int heading = 0;
};

/// A state that a way may begin or end in, and what lies between it and the true pose.
struct HeadingEnd {
  HeadingState state{};
  double cost = 0.0;  ///< m, ≥ 0
};

enum class HeadingStep : std::uint8_t { forwards = 0, backwards = 1, to_next = 2, to_previous = 3 };

struct HeadingAnswer {
  SearchEnd ended = SearchEnd::unreachable;
  HeadingState first{};
  std::vector<HeadingStep> steps;
  HeadingState last{};
  double cost = 0.0;  ///< m
  std::int64_t expansions = 0;
};

class HeadingSearch {
 public:
  HeadingSearch();
  ~HeadingSearch();
  HeadingSearch(HeadingSearch&&) noexcept;
  HeadingSearch& operator=(HeadingSearch&&) noexcept;

  /// The least costly way; `expansions` and `budget` as in GridQuery.
  HeadingAnswer run(const HeadingSpace& space, const std::vector<HeadingEnd>& starts, const std::vector<HeadingEnd>& goals, Heuristic heuristic,
                    std::optional<std::int64_t> expansions, Budget* budget, MotionCheck& test);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace waywright
