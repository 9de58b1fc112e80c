// The tables of the publication on RRT* with the whale optimisation algorithm run again on its reconstructed maps. It prints means over 100 runs a map, and tells neither
// scale nor map of most of them: what can be compared is the share of the possible saving, and what each parameter does.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace waywright::rrt_woa {

/// Of many runs.
struct Mean {
  double value = 0.0;
  double half_width = 0.0;  ///< of the 95 % interval of the mean, by its standard error
};

struct Outcome {
  double seconds = 0.0, metres = 0.0, nodes = 0.0;  ///< as printed
};
struct Measured {
  Mean seconds, metres, nodes;  ///< over all maps and seeds
  Mean share;                   ///< of the saving that is possible, (L_RRT* − L) / (L_RRT* − L_shortest), of the sums over the maps, seed by seed
  std::vector<double> metres_by_seed, nodes_by_seed;  ///< over the maps; seeds in the same order in every row
};

enum class Variant { rrt_star, local, global };

/// A row of a table: what was printed and what came out here.
struct Row {
  double value = 0.0;   ///< of the parameter
  double start = 2.0;   ///< a₀, in the tables of a₀ and λ
  Outcome published;
  Measured ours;
};

struct Table {
  std::string name;       ///< "3.2"
  Variant variant = Variant::local;
  std::string parameter;  ///< "population", "iterations", "mu", "b", "a0", "lambda"
  std::vector<Row> rows;
};

struct Results {
  std::array<Row, 3> comparison;  ///< table 3.1, by Variant; with the configuration file's a₀ = 4
  std::vector<Table> tables;      ///< 3.2 to 3.13
  std::array<double, 5> shortest{};                    ///< m, of a point on each map
  std::array<std::array<Measured, 3>, 5> by_map{};     ///< of the comparison
  int runs = 0;  ///< seeds a map
};

/// First paths of RRT* with the publication's parameters, for a point on each of the five maps, and both variants; seeds 1 to `runs`. Where `cancel` was raised, less.
Results run(int runs, const std::atomic<bool>* cancel);

std::string text(const Results& results);
std::string csv(const Results& results);

/// What each parameter does to length and nodes, as printed and here: a sentence each where the 95 % interval (Student) of what the same seeds differ by from row to row holds
/// nothing of what is printed, and where it holds both that and its contrary. Of the tables of λ what counts is that 0 gives the longest ways.
struct Trends {
  int holding = 0;
  std::vector<std::string> broken, undecided;
};
Trends trends(const Results& results);

/// Length against each parameter, printed and ours, each in per cent of its own first row.
std::string svg(const Results& results, double width);

}  // namespace waywright::rrt_woa
