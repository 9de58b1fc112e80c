#include "waywright/planner/field/harmonic.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>

namespace waywright {
namespace {

constexpr std::array<Cell, 4> beside{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
constexpr double least_value = 1e-300;

}  // namespace

HarmonicField::HarmonicField(const GridFrame& frame, const std::vector<Cell>& goals, const std::function<bool(Cell)>& is_free, const std::function<bool(Cell, Cell)>& may_drive,
                             const Options& options)
    : frame_{frame} {
  const auto cells = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  values_.assign(cells, 0.0);
  links_.assign(cells, 0);
  // Outwards from the goal: what it is connected to, with the numbers of the unknowns.
  std::vector<int> number(cells, -1);
  std::vector<Cell> reached;
  std::vector<std::uint8_t> is_known(cells, 0), stands(cells, 2);
  const auto can_stand = [&](Cell c) {
    std::uint8_t& s = stands[index(c)];
    if (s == 2) s = is_free(c) ? 1 : 0;
    return s == 1;
  };
  for (const Cell c : goals) {
    if (is_known[index(c)] != 0) continue;
    is_known[index(c)] = 1;
    values_[index(c)] = 1.0;
    reached.push_back(c);
  }
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Cell c = reached[i];
    for (std::size_t k = 0; k < beside.size(); ++k) {
      const Cell to{c.column + beside[k].column, c.row + beside[k].row};
      if (!frame.contains(to) || !can_stand(to)) continue;
      const bool is_linked_back = (links_[index(to)] >> ((k + 2) % 4) & 1U) != 0;
      if (!is_linked_back && !may_drive(c, to)) continue;
      links_[index(c)] = static_cast<std::uint8_t>(links_[index(c)] | 1U << k);
      links_[index(to)] = static_cast<std::uint8_t>(links_[index(to)] | 1U << ((k + 2) % 4));
      if (is_known[index(to)] != 0 || number[index(to)] >= 0) continue;
      if (unknowns_ == options.most_unknowns) {
        is_over_ = true;
        return;
      }
      number[index(to)] = static_cast<int>(unknowns_++);
      reached.push_back(to);
    }
  }
  if (unknowns_ == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns_);
  for (const Cell c : reached) {
    const int n = number[index(c)];
    if (n < 0) continue;
    double diagonal = 0.0;
    for (std::size_t k = 0; k < beside.size(); ++k) {
      if ((links_[index(c)] >> k & 1U) == 0) {
        diagonal += options.absorption;
        continue;
      }
      diagonal += 1.0;
      const Cell to{c.column + beside[k].column, c.row + beside[k].row};
      if (is_known[index(to)] != 0) right[n] += 1.0;
      else if (number[index(to)] < n) entries.emplace_back(n, number[index(to)], -1.0);  // the lower half
    }
    entries.emplace_back(n, n, diagonal);
  }
  Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver{matrix};
  if (solver.info() != Eigen::Success) return;
  const Eigen::VectorXd solved = solver.solve(right);
  for (const Cell c : reached) {
    const int n = number[index(c)];
    if (n >= 0 && solved[n] >= least_value) values_[index(c)] = solved[n];
  }
}

bool HarmonicField::may_drive(Cell from, Cell to) const {
  for (std::size_t k = 0; k < beside.size(); ++k) {
    if (from.column + beside[k].column == to.column && from.row + beside[k].row == to.row) return (links_[index(from)] >> k & 1U) != 0;
  }
  return false;
}

HarmonicField::Value HarmonicField::at(Vec2 world) const {
  const Vec2 in = frame_.in_cells(world) - Vec2{0.5, 0.5};  // middles have whole numbers; rows go down
  const double column = std::floor(in.x), row = std::floor(in.y), u = in.x - column, v = in.y - row;
  const Cell c{static_cast<int>(std::clamp(column, -2.0, frame_.columns + 1.0)), static_cast<int>(std::clamp(row, -2.0, frame_.rows + 1.0))};
  const double a = at(c), b = at(Cell{c.column + 1, c.row}), d = at(Cell{c.column, c.row + 1}), e = at(Cell{c.column + 1, c.row + 1});
  const double along = (1.0 - v) * (b - a) + v * (e - d), down = (1.0 - u) * (d - a) + u * (e - b);
  return {(1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * d + u * e), (1.0 / frame_.cell) * frame_.frame.rotate({along, -down})};
}

}  // namespace waywright
