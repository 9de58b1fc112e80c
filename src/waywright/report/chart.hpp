// Line charts along the path.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace waywright {

struct ChartLimit {
  double value;
  std::string name;
};

struct Chart {
  std::string title;  ///< with its unit
  std::vector<double> s, value;
  std::vector<int> direction;      ///< per sample, for the bands
  std::vector<ChartLimit> limits;  ///< dashed lines
  bool from_zero = true;           ///< the axis includes 0
};

std::string chart_svg(const Chart& chart, double width, double height);

}  // namespace waywright
