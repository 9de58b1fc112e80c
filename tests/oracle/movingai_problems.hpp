// MovingAI's problems with their published optimal lengths, for tests.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace waywright::oracle {

struct MovingAiProblem {
  int start_column = 0, start_row = 0, goal_column = 0, goal_row = 0;
  double length = 0.0;  ///< cells, rounded in the older files
};

/// bucket, map, width, height, start x, start y, goal x, goal y, length; (0, 0) is the upper left cell. What is no such line is left out.
inline std::vector<MovingAiProblem> read_movingai_problems(const std::string& file) {
  std::vector<MovingAiProblem> problems;
  std::ifstream in{file};
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields{line};
    std::string bucket, map;
    int width = 0, height = 0;
    MovingAiProblem p;
    if (fields >> bucket >> map >> width >> height >> p.start_column >> p.start_row >> p.goal_column >> p.goal_row >> p.length) problems.push_back(p);
  }
  return problems;
}

}  // namespace waywright::oracle
