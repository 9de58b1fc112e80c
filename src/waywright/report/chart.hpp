// Line charts along the path, or in time.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace waywright {

struct ChartLimit {
  double value;
  std::string name;
};

/// One of several curves in one chart.
struct ChartSeries {
  std::string name;
  std::string stroke;  ///< attributes of its line, as XML
  std::vector<double> s, value;
};

/// Either one curve with bands of its directions, or several beside each other, named below.
struct Chart {
  std::string title;  ///< with its unit
  std::vector<double> s, value;
  std::vector<int> direction;      ///< per sample, for the bands: 1 forwards, -1 backwards, 2 to the left, -2 to the right, 0 none of them
  bool names_bands = false;        ///< writes "forward", "left" … in bands that have room for it
  std::vector<double> ceiling{};   ///< per sample: a limit that changes along the way, infinity where there is none; empty: nowhere
  std::vector<ChartLimit> limits;  ///< dashed lines, named to the right of the plot
  std::vector<double> stops;       ///< s of marks across the plot
  std::vector<ChartLimit> borders{};  ///< s at which a part begins, with its name at the plot's upper edge
  std::vector<ChartSeries> series;
  std::string axis = "s in m";  ///< what is to the right; empty: said elsewhere
  std::optional<std::pair<double, double>> range{};  ///< values that the plot reaches over at least, so that charts beside each other compare
  double right = 84.0;  ///< px beside the plot, for the names of limits
};

std::string chart_svg(const Chart& chart, double width, double height);

}  // namespace waywright
