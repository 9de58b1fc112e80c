#include "bench/yardstick/plain_waypoints.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace yardstick {
namespace {

double to_side(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - (a + t * along)).norm();
}

double to_ring(const Point& p, const Polygon& ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, to_side(p, ring[i], ring[(i + 1) % ring.size()]));
  return least;
}

bool is_inside(const Point& p, const Polygon& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

Polygon placed(const Polygon& footprint, const Pose& pose) {
  const Eigen::Rotation2Dd turn{pose.heading};
  Polygon world;
  for (const Point& p : footprint) world.push_back(turn * p + Point{pose.x, pose.y});
  return world;
}

struct Box {
  Point low, high;
};

Box box_of(const Polygon& ring) {
  Box box{ring.front(), ring.front()};
  for (const Point& p : ring) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

double apart(const Box& a, const Box& b) {
  const double dx = std::max({0.0, a.low.x() - b.high.x(), b.low.x() - a.high.x()});
  const double dy = std::max({0.0, a.low.y() - b.high.y(), b.low.y() - a.high.y()});
  return std::hypot(dx, dy);
}

Distances distances(const Hall& hall, const std::vector<Pose>& poses, bool boxes_first) {
  std::vector<Box> boxes;
  for (const Polygon& ring : hall.objects) boxes.push_back(box_of(ring));
  Distances result;
  for (const Pose& pose : poses) {
    const Polygon vehicle = placed(hall.footprint, pose);
    const Box own = box_of(vehicle);
    double least = std::numeric_limits<double>::infinity();
    double depth = 0.0;
    for (std::size_t k = 0; k < hall.objects.size(); ++k) {
      const Polygon& ring = hall.objects[k];
      const bool is_border = k == 0;
      if (boxes_first && !is_border) {
        const double away = apart(own, boxes[k]);
        if (away > 0.0 && away >= least) continue;
      }
      for (const Point& corner : vehicle) {
        const double d = to_ring(corner, ring);
        if (is_inside(corner, ring) != is_border) {
          depth = std::max(depth, d);
          least = 0.0;
        } else {
          least = std::min(least, d);
        }
      }
      if (is_border) continue;
      for (const Point& corner : ring) {
        const double d = to_ring(corner, vehicle);
        if (is_inside(corner, vehicle)) {
          depth = std::max(depth, d);
          least = 0.0;
        } else {
          least = std::min(least, d);
        }
      }
    }
    result.distance.push_back(least);
    result.depth.push_back(depth);
  }
  return result;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

template <class F>
double integral(const F& f) {
  constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975362};
  constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  double sum = 0.0;
  for (int part = 0; part < 4; ++part) {
    const double middle = 0.25 * (part + 0.5);
    for (int i = 0; i < 4; ++i) sum += 0.125 * weight[i] * (f(middle - 0.125 * node[i]) + f(middle + 0.125 * node[i]));
  }
  return sum;
}

}  // namespace

Distances distances_plain(const Hall& hall, const std::vector<Pose>& poses) { return distances(hall, poses, false); }
Distances distances_boxes_first(const Hall& hall, const std::vector<Pose>& poses) { return distances(hall, poses, true); }

FittedClothoid fit_textbook(const Pose& from, const Pose& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double r = std::hypot(dx, dy);
  const double phi = std::atan2(dy, dx);
  const double phi0 = wrapped(from.heading - phi), phi1 = wrapped(to.heading - phi);
  const double delta = phi1 - phi0;
  double a = 3.0 * (phi0 + phi1);
  for (int i = 0; i < 20; ++i) {
    const double g = integral([&](double t) { return std::sin(a * t * t + (delta - a) * t + phi0); });
    const double slope = integral([&](double t) { return std::cos(a * t * t + (delta - a) * t + phi0) * (t * t - t); });
    a -= g / slope;
    if (std::abs(g) < 1e-12) break;
  }
  const double length = r / integral([&](double t) { return std::cos(a * t * t + (delta - a) * t + phi0); });
  return {length, (delta - a) / length, 2.0 * a / (length * length)};
}

std::vector<Pose> sample_textbook(const std::vector<Pose>& through, int samples) {
  std::vector<FittedClothoid> legs;
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    legs.push_back(fit_textbook(through[i], through[i + 1]));
    total += legs.back().length;
  }
  std::vector<Pose> poses;
  std::size_t leg = 0;
  double begin = 0.0;  // of the leg
  double before = 0.0;
  Point position{through[0].x, through[0].y};
  for (int i = 0; i < samples; ++i) {
    const double s = total * i / (samples - 1);
    while (leg + 1 < legs.size() && s > begin + legs[leg].length) {
      begin += legs[leg++].length;
      before = begin;
      position = {through[leg].x, through[leg].y};
    }
    const FittedClothoid& c = legs[leg];
    const auto course = [&](double along) { return through[leg].heading + along * (c.curvature + 0.5 * c.rate * along); };
    const double from = before - begin, by = s - before;
    constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975362};
    constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    for (int k = 0; k < 4; ++k) {
      for (const double side : {-1.0, 1.0}) {
        const double angle = course(from + 0.5 * by * (1.0 + side * node[k]));
        position += 0.5 * by * weight[k] * Point{std::cos(angle), std::sin(angle)};
      }
    }
    before = s;
    poses.push_back({position.x(), position.y(), course(s - begin)});
  }
  return poses;
}

double candidate_plain(const Hall& hall, const std::vector<Pose>& through, int samples) {
  const Distances d = distances_plain(hall, sample_textbook(through, samples));
  const Box border = box_of(hall.objects.front());
  const double reference = 0.5 * (border.high - border.low).norm();
  double depth = 0.0, distance = 0.0;
  bool is_in_contact = false;
  for (std::size_t i = 0; i < d.distance.size(); ++i) {
    is_in_contact = is_in_contact || d.depth[i] > 0.0;
    depth += d.depth[i];
    distance += std::min(d.distance[i], reference);
  }
  return is_in_contact ? 1.0 + depth / samples / reference : 1.0 - distance / samples / reference;
}

}  // namespace yardstick
