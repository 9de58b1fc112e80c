// A docking station made of bytes: mostly what could be, with awkward numbers strewn in.
#pragma once

#include <string>

#include "waywright/scenario/scenario.hpp"

namespace waywright::fuzz {

/// Numbers taken from bytes, one after the other; zeros where they have run out.
class ByteSource {
 public:
  explicit ByteSource(const std::string& bytes) : bytes_{bytes} {}

  int below(int n) { return byte() % n; }
  bool one_in(int n) { return below(n) == n - 1; }
  /// In [low, high], now and then one of its ends, what came before, or just beside that.
  double real(double low, double high);
  Vec2 point(Vec2 low, Vec2 high);

 private:
  int byte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : 0; }

  const std::string& bytes_;
  std::size_t at_ = 0;
  double before_ = 0.0;
};

/// What is found while a plan is driven.
struct Surprise {
  double at = 0.0;           ///< share of the plan's time
  Pose shelf{};              ///< how far the shelf is off, in its own frame
  Pose vehicle{};            ///< how far the vehicle is off the plan, in its own frame
  double curvature = 0.0;    ///< 1/m, by how much its way bends more
};

struct StationBytes {
  Scenario scenario;  ///< not checked yet: what a reader would refuse may be in it
  Surprise surprise;
};
StationBytes station_of(const std::string& bytes);

}  // namespace waywright::fuzz
