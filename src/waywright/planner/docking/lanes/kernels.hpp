// The inner loops of the docking search, sixteen path samples at a time: one quintic traced, and its poses screened against
// the clearance field. Written once, compiled for each instruction set, chosen at run time; every one gives the same bits, because
// each lane is plain IEEE arithmetic in a fixed order.
//
// Single precision, metres relative to the field's corner: what is decided by these loops keeps a margin for that, and a path is
// accepted by the proof alone.
#pragma once

#include <cstdint>
#include <span>

namespace waywright::lanes {

inline constexpr int width = 16;
inline constexpr int stretches = 6;                          ///< of sixteen samples each; neighbours share one
inline constexpr int samples = stretches * (width - 1) + 1;  ///< of a quintic: 90 intervals of equal parameter, both ends included
inline constexpr int traced = stretches * width;
inline constexpr int padded = traced + width;

/// Quintic whose second derivative is `bend` where it begins and vanishes where it ends:
/// p(u) = from + E(u)·chord + A(u)·tangent + C(u)·end_tangent + B(u)·bend.
struct Quintic {
  float from_x, from_y;
  float chord_x, chord_y;
  float tangent_x, tangent_y;          ///< dp/du at u = 0
  float end_tangent_x, end_tangent_y;  ///< dp/du at u = 1
  float bend_x, bend_y;                ///< d²p/du² at u = 0
  float facing;                        ///< +1: the vehicle's heading is the tangent, −1: against it
};

/// What a traced quintic is like. Elements from `samples` on repeat the last one (of intervals: 0).
struct alignas(64) Track {
  float x[padded], y[padded];                  ///< m
  float heading_x[padded], heading_y[padded];  ///< unit vector of the vehicle's heading
  float curvature[padded];                     ///< 1/m, in the direction of travel
  float rate[padded];                          ///< dκ/ds, 1/m²
  float step[padded];                          ///< m of the interval that begins here, an upper bound
  float turn[padded];                          ///< rad turned in it, an upper bound
  float length;                                ///< m
  float curvature_change;                      ///< Σ|Δκ|, 1/m
  float max_curvature;                         ///< 1/m, peaks between samples included
  float max_rate;                              ///< 1/m²
};

/// Lower bounds of the distance to anything blocked, one a cell; under 0 where nothing is known, as in all its rim.
struct Field {
  const float* value = nullptr;  ///< row-major, the first row at the low end of y; a row takes 2^row_shift values
  int row_shift = 0;
  std::int32_t last_column = 0, last_row = 0;
  float inverse_cell = 0.0F;  ///< 1/m
};

/// One disc of the footprint's cover, centre in the body frame.
struct Disc {
  float x, y;
  float reach;  ///< m from the body's origin
  float outer;  ///< m: a field value above it: the disc is clear there
  float inner;  ///< m: a field value from 0 up to it: the footprint is surely too near
  float middle;  ///< m: between the two, for what is only a measure
};

struct Discs {
  const Disc* first = nullptr;
  int count = 0;
};

struct Screen {
  std::uint16_t open[stretches];  ///< bit k of b: interval 15 b + k is not shown to be clear
  int hit;                        ///< first sample that is surely too near; `samples`: none. What comes after it is not settled
  float deficit;                  ///< ∫ Σ max(0, middle − field) ds over the coarse discs, m²: how deep and how long it is where it must not be
};

struct Kernels {
  const char* name;
  /// `with_rate` false: the rate of curvature is left alone, and max_rate is 0.
  void (*trace)(const Quintic&, bool with_rate, Track&);
  /// `fine` is asked where `coarse`, another cover of the same footprint, does not settle a stretch.
  void (*screen)(const Track&, Discs coarse, Discs fine, const Field&, Screen&);
};

/// Those that this processor can run, the plainest first.
std::span<const Kernels> available();
/// The widest of them.
const Kernels& best();

}  // namespace waywright::lanes
