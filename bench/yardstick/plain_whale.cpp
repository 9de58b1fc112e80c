#include "bench/yardstick/plain_whale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace yardstick {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

double point_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + t * along)).norm();
}

double side_of(const Vector2d& a, const Vector2d& b, const Vector2d& p) { return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()); }

bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0.0 && side_of(c, d, a) * side_of(c, d, b) < 0.0;
}

double segment_to_segment(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  if (cross(a, b, c, d)) return 0.0;
  return std::min({point_to_segment(a, c, d), point_to_segment(b, c, d), point_to_segment(c, a, b), point_to_segment(d, a, b)});
}

bool inside(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    if ((polygon[i].y() > p.y()) != (polygon[j].y() > p.y()) &&
        p.x() < (polygon[j].x() - polygon[i].x()) * (p.y() - polygon[i].y()) / (polygon[j].y() - polygon[i].y()) + polygon[i].x()) {
      in = !in;
    }
  }
  return in;
}

std::vector<Vector2d> points_of(const std::vector<Vector2d>& way, const VectorXd& corners) {
  std::vector<Vector2d> points{way.front()};
  for (Eigen::Index i = 0; i + 1 < corners.size(); i += 2) points.emplace_back(corners[i], corners[i + 1]);
  points.push_back(way.back());
  return points;
}

double cost_of(const WhaleScene& scene, const std::vector<Vector2d>& points) {
  double length = 0.0;
  bool collides = false;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i] - points[i - 1]).norm();
    for (const auto& polygon : scene.obstacles) {
      if (inside(polygon, points[i])) collides = true;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        if (segment_to_segment(points[i - 1], points[i], polygon[k], polygon[(k + 1) % polygon.size()]) <= scene.radius) collides = true;
      }
    }
  }
  return length + (collides ? 1000.0 : 0.0);
}

}  // namespace

WhaleWay whale_plain(const WhaleScene& scene, const std::vector<Vector2d>& way, int population, int iterations, double bound, unsigned seed) {
  std::mt19937_64 engine{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  std::uniform_int_distribution<int> any{0, population - 1};
  const auto corners = static_cast<Eigen::Index>(way.size() - 2);
  VectorXd original(2 * corners);
  for (Eigen::Index i = 0; i < corners; ++i) original.segment<2>(2 * i) = way[static_cast<std::size_t>(i) + 1];
  const VectorXd low = original.array() - bound, high = original.array() + bound;
  std::vector<VectorXd> agents(static_cast<std::size_t>(population), original);
  for (std::size_t i = 1; i < agents.size(); ++i) {
    for (Eigen::Index k = 0; k < corners; ++k) {
      const double r = bound * std::sqrt(unit(engine)), a = 2.0 * std::numbers::pi * unit(engine);
      agents[i].segment<2>(2 * k) += Vector2d{r * std::cos(a), r * std::sin(a)};
    }
  }
  VectorXd best = original;
  double best_cost = cost_of(scene, way);
  const auto evaluate = [&] {
    for (const VectorXd& agent : agents) {
      const double cost = cost_of(scene, points_of(way, agent));
      if (cost < best_cost) {
        best_cost = cost;
        best = agent;
      }
    }
  };
  evaluate();
  for (int t = 0; t < iterations; ++t) {
    const double a = 4.0 * (1.0 - static_cast<double>(t) / iterations);
    const VectorXd leader = best;
    for (VectorXd& agent : agents) {
      const double r1 = unit(engine), r2 = unit(engine), p = unit(engine), l = 2.0 * unit(engine) - 1.0;
      const double A = 2.0 * a * r1 - a, C = 2.0 * r2;
      if (p < 0.5) {
        const VectorXd target = std::abs(A) < 1.0 ? leader : agents[static_cast<std::size_t>(any(engine))];
        agent = target - A * (C * (target - original) - (agent - original)).cwiseAbs();
      } else {
        agent = leader + std::exp(l) * std::cos(2.0 * std::numbers::pi * l) * (leader - agent).cwiseAbs();
      }
      agent = agent.cwiseMax(low).cwiseMin(high);
    }
    evaluate();
  }
  return {points_of(way, best), best_cost};
}

}  // namespace yardstick
