// Line charts along the path, or in time.
#pragma once

#include <string>
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
  std::vector<int> direction;      ///< per sample, for the bands
  std::vector<double> ceiling{};   ///< per sample: a limit that changes along the way, infinity where there is none; empty: nowhere
  std::vector<ChartLimit> limits;  ///< dashed lines, named to the right of the plot
  std::vector<double> stops;       ///< s of marks across the plot
  std::vector<ChartLimit> borders{};  ///< s at which a part begins, with its name at the plot's upper edge
  std::vector<ChartSeries> series;
  std::string axis = "s in m";  ///< what is to the right
};

std::string chart_svg(const Chart& chart, double width, double height);

}  // namespace waywright
