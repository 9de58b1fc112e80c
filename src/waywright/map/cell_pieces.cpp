#include "waywright/map/cell_pieces.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_set>

namespace waywright {
namespace {

constexpr std::int32_t none = -1;

/// Cells with their cuts and labels.
class Pieces {
 public:
  Pieces(int columns, int rows, const std::vector<std::uint8_t>& blocked)
      : columns_{columns}, rows_{rows}, blocked_{blocked}, is_cut_(blocked.size(), false), label_(blocked.size(), none) {}

  std::vector<CellPiece> take() {
    cut_around_holes();
    std::vector<CellPiece> pieces;
    // Columns from the left, so that a piece is met first at the lowest of its leftmost cells.
    for (int column = 0; column < columns_; ++column) {
      for (int row = rows_ - 1; row >= 0; --row) {
        if (!is_blocked(column, row) || label_[index(column, row)] != none) continue;
        CellPiece piece;
        const auto label = static_cast<std::int32_t>(pieces.size());
        piece.cells = fill(column, row, label);
        follow(column, row, label, piece);
        pieces.push_back(std::move(piece));
      }
    }
    return pieces;
  }

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column); }
  bool contains(int column, int row) const { return column >= 0 && row >= 0 && column < columns_ && row < rows_; }
  bool is_blocked(int column, int row) const { return contains(column, row) && blocked_[index(column, row)] != 0; }
  /// Grid corner at the upper left of the cell.
  std::int64_t corner(int column, int row) const { return static_cast<std::int64_t>(row) * (columns_ + 1) + column; }

  /// Free regions, by their sides, that do not reach the border.
  void cut_around_holes() {
    std::vector<bool> seen(blocked_.size(), false);
    std::vector<Cell> open;
    for (int first_row = 0; first_row < rows_; ++first_row) {
      for (int first_column = 0; first_column < columns_; ++first_column) {
        const std::size_t first = index(first_column, first_row);
        if (blocked_[first] != 0 || seen[first]) continue;
        Cell left{first_column, first_row}, right = left;
        bool is_hole = true;
        open.assign(1, left);
        seen[first] = true;
        while (!open.empty()) {
          const Cell c = open.back();
          open.pop_back();
          if (c.column < left.column) left = c;
          if (c.column > right.column) right = c;
          for (const Cell n : {Cell{c.column - 1, c.row}, Cell{c.column + 1, c.row}, Cell{c.column, c.row - 1}, Cell{c.column, c.row + 1}}) {
            if (!contains(n.column, n.row)) {
              is_hole = false;
              continue;
            }
            const std::size_t at = index(n.column, n.row);
            if (blocked_[at] != 0 || seen[at]) continue;
            seen[at] = true;
            open.push_back(n);
          }
        }
        if (!is_hole) continue;
        cut_from(left, -1);
        cut_from(right, 1);
      }
    }
  }

  /// How many cells a cut from the cell's side goes along its upper (row) or lower (row + 1) line before a cell is free on either side.
  int reach(int column, int line, int step) const {
    int steps = 0;
    while (is_blocked(column + step * (steps + 1), line - 1) && is_blocked(column + step * (steps + 1), line)) ++steps;
    return steps;
  }

  void cut_from(Cell from, int step) {
    const int upper = reach(from.column, from.row, step), lower = reach(from.column, from.row + 1, step);
    const int line = upper <= lower ? from.row : from.row + 1;
    const int steps = std::min(upper, lower);
    // Nothing to cut along: two cells touch at this corner, and are taken apart there.
    if (steps == 0) apart_.insert(corner(step < 0 ? from.column : from.column + 1, line));
    for (int s = 1; s <= steps; ++s) is_cut_[index(from.column + step * s, line)] = true;
  }

  /// Labels what hangs together with the cell; how many cells.
  std::int64_t fill(int column, int row, std::int32_t label) {
    std::int64_t count = 0;
    open_.assign(1, {column, row});
    label_[index(column, row)] = label;
    const auto take = [&](int c, int r) {
      if (!is_blocked(c, r) || label_[index(c, r)] != none) return;
      label_[index(c, r)] = label;
      open_.push_back({c, r});
    };
    while (!open_.empty()) {
      const Cell c = open_.back();
      open_.pop_back();
      ++count;
      take(c.column - 1, c.row);
      take(c.column + 1, c.row);
      if (!is_cut_[index(c.column, c.row)]) take(c.column, c.row - 1);
      if (c.row + 1 < rows_ && !is_cut_[index(c.column, c.row + 1)]) take(c.column, c.row + 1);
      for (const int right : {0, 1}) {
        for (const int below : {0, 1}) {
          const int other_column = c.column + 2 * right - 1, other_row = c.row + 2 * below - 1;
          if (is_blocked(other_column, c.row) || is_blocked(c.column, other_row) || apart_.contains(corner(c.column + right, c.row + below))) continue;
          take(other_column, other_row);
        }
      }
    }
    return count;
  }

  /// The outline, with the piece on the left, from the lower left corner of the lowest of its leftmost cells.
  void follow(int column, int row, std::int32_t label, CellPiece& piece) {
    struct Step {
      int x, y;
    };
    constexpr std::array<Step, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};  // y upwards
    const auto is_in = [&](int x, int y) {  // the cell whose lower left corner is (x, y)
      const int r = rows_ - 1 - y;
      return contains(x, r) && label_[index(x, r)] == label;
    };
    /// The cell ahead of a corner, to one side of the direction.
    const auto ahead = [&](int x, int y, Step d, bool left) {
      // Twice the middle: corner + direction ± its left.
      const int side = left ? 1 : -1;
      const int mx = 2 * x + d.x - side * d.y, my = 2 * y + d.y + side * d.x;
      return is_in((mx - 1) / 2, (my - 1) / 2);
    };
    const int first_x = column, first_y = rows_ - 1 - row;
    int x = first_x, y = first_y;
    std::size_t heading = 0;
    const auto add = [&](HalfCell p) {
      auto& o = piece.outline;
      if (!o.empty() && o.back() == p) return;
      while (o.size() >= 2 && turn(o[o.size() - 2], o.back(), p) == 0) o.pop_back();
      o.push_back(p);
    };
    add({2 * x, 2 * y});
    do {
      x += steps[heading].x;
      y += steps[heading].y;
      const Step d = steps[heading];
      const bool left = ahead(x, y, d, true), right = ahead(x, y, d, false);
      if (right) {
        const std::size_t next = (heading + 3) % 4;
        if (!left) {
          piece.is_bridged = true;
          add({2 * x - d.x, 2 * y - d.y});
          add({2 * x + steps[next].x, 2 * y + steps[next].y});
        } else {
          add({2 * x, 2 * y});
        }
        heading = next;
      } else if (!left) {
        add({2 * x, 2 * y});
        heading = (heading + 1) % 4;
      }
    } while (x != first_x || y != first_y);
    piece.outline.pop_back();  // the first corner again
  }

  static std::int64_t turn(HalfCell a, HalfCell b, HalfCell c) {
    return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
  }

  int columns_, rows_;
  const std::vector<std::uint8_t>& blocked_;
  std::vector<bool> is_cut_;                // between this cell and the one above
  std::unordered_set<std::int64_t> apart_;  // corners where cells that touch are in different pieces
  std::vector<std::int32_t> label_;
  std::vector<Cell> open_;
};

}  // namespace

std::vector<CellPiece> pieces_of(int columns, int rows, const std::vector<std::uint8_t>& blocked) { return Pieces{columns, rows, blocked}.take(); }

}  // namespace waywright
