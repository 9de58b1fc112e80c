#include "waywright/planner/grid/grid_graph.hpp"

#include <algorithm>
#include <utility>

namespace waywright {
namespace {

constexpr std::uint16_t blocked_component = 0;
constexpr std::uint16_t one_of_many = 65535;

/// The free cells with a rim of two blocked ones, so that no move has to look where the grid ends.
class Rimmed {
 public:
  Rimmed(int columns, int rows, std::span<const std::uint8_t> blocked)
      : width_{static_cast<std::size_t>(columns) + 4}, free_(width_ * (static_cast<std::size_t>(rows) + 4), 0) {
    const auto count = static_cast<std::size_t>(columns);
    for (int r = 0; r < rows; ++r) {
      const std::uint8_t* from = blocked.data() + static_cast<std::size_t>(r) * count;
      std::uint8_t* to = free_.data() + (static_cast<std::size_t>(r) + 2) * width_ + 2;
      for (std::size_t c = 0; c < count; ++c) to[c] = from[c] == 0 ? 1 : 0;
    }
  }
  /// The row of free cells `row` that begins `column` cells into it.
  const std::uint8_t* at(int column, int row) const {
    return free_.data() + (static_cast<std::size_t>(row + 2)) * width_ + static_cast<std::size_t>(column + 2);
  }

 private:
  std::size_t width_;
  std::vector<std::uint8_t> free_;
};

/// The two cells beside or under a move, from its beginning.
std::pair<Move, Move> crossed(Move m) {
  if (std::abs(m.column) == 2) return {{m.column / 2, 0}, {m.column / 2, m.row}};
  if (std::abs(m.row) == 2) return {{0, m.row / 2}, {m.column, m.row / 2}};
  return {{m.column, 0}, {0, m.row}};
}

}  // namespace

GridGraph::GridGraph(int columns, int rows, std::span<const std::uint8_t> blocked, Neighbours neighbours, CornerRule corners)
    : columns_{columns}, rows_{rows}, neighbours_{neighbours}, free_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {
  const Rimmed cells{columns, rows, blocked};
  for (int r = 0; r < rows; ++r) {
    std::uint16_t* out = free_.data() + index(0, r);
    const std::uint8_t* here = cells.at(0, r);
    for (int i = 0; i < all_moves; i += steps_of(neighbours)) {
      const Move m = moves[static_cast<std::size_t>(i)];
      const std::uint8_t* there = cells.at(m.column, r + m.row);
      const auto [first, second] = crossed(m);
      const std::uint8_t* a = cells.at(first.column, r + first.row);
      const std::uint8_t* b = cells.at(second.column, r + second.row);
      const bool is_either = kind_of(i) == MoveKind::diagonal && corners == CornerRule::loose;
      for (int c = 0; c < columns; ++c) {
        const int beside = is_either ? a[c] | b[c] : a[c] & b[c];
        out[c] = static_cast<std::uint16_t>(out[c] | ((here[c] & there[c] & (kind_of(i) == MoveKind::straight ? 1 : beside)) << i));
      }
    }
  }
  // A free cell without a move is a component of its own; it has no bit to be seen by.
  label_components();
}

GridGraph::GridGraph(int columns, int rows, Neighbours neighbours, std::vector<std::uint16_t> free, std::vector<std::uint16_t> asked)
    : columns_{columns}, rows_{rows}, neighbours_{neighbours}, free_{std::move(free)}, asked_{std::move(asked)} {
  label_components();
}

void GridGraph::set_danger(std::span<const std::uint16_t> danger) {
  danger_.clear();
  most_danger_ = 0;
  if (danger.empty()) return;
  danger_.assign(danger.size() + 2 * margin(), 0);
  std::copy(danger.begin(), danger.end(), danger_.begin() + static_cast<std::ptrdiff_t>(margin()));
  most_danger_ = *std::max_element(danger.begin(), danger.end());
}

void GridGraph::set_zones(GridZones zones) {
  zones_ = std::move(zones);
  if (zones_.empty()) return;
  for (std::size_t cell = 0; cell < free_.size(); ++cell) {
    const auto allowed = static_cast<std::uint16_t>(~zones_.against(cell));
    free_[cell] = static_cast<std::uint16_t>(free_[cell] & allowed);
    if (!asked_.empty()) asked_[cell] = static_cast<std::uint16_t>(asked_[cell] & allowed);
  }
}

void GridGraph::label_components() {
  component_.assign(free_.size(), blocked_component);
  std::vector<std::uint32_t> waiting;
  std::array<std::ptrdiff_t, all_moves> offsets{};
  for (std::size_t i = 0; i < moves.size(); ++i) offsets[i] = moves[i].row * static_cast<std::ptrdiff_t>(columns_) + moves[i].column;
  const auto moves_from = [&](std::size_t cell) { return static_cast<unsigned>(asked_.empty() ? free_[cell] : free_[cell] | asked_[cell]); };
  for (std::size_t start = 0; start < free_.size(); ++start) {
    if (component_[start] != blocked_component || moves_from(start) == 0) continue;
    const auto label = static_cast<std::uint16_t>(std::min<std::int64_t>(++components_, one_of_many));
    component_[start] = label;
    waiting.push_back(static_cast<std::uint32_t>(start));
    while (!waiting.empty()) {
      const std::uint32_t cell = waiting.back();
      waiting.pop_back();
      for (unsigned rest = moves_from(cell); rest != 0; rest &= rest - 1) {
        const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + offsets[static_cast<std::size_t>(__builtin_ctz(rest))]);
        if (component_[next] != blocked_component) continue;
        component_[next] = label;
        waiting.push_back(static_cast<std::uint32_t>(next));
      }
    }
  }
}

bool GridGraph::may_be_connected(Cell a, Cell b) const {
  if (a == b) return true;
  const std::uint16_t of_a = component_[index(a)], of_b = component_[index(b)];
  return of_a == of_b && of_a != blocked_component;
}

}  // namespace waywright
