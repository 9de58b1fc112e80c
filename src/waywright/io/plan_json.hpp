// What the writer and the reader of plan.json share: the names of the fields.
#pragma once

#include "waywright/metrics/metrics.hpp"
#include "waywright/path/path.hpp"

namespace waywright {

struct MetricField {
  const char* name;
  double Metrics::*value;
};
inline constexpr MetricField metric_fields[] = {
    {"length", &Metrics::length},
    {"min_clearance", &Metrics::min_clearance},
    {"mean_clearance", &Metrics::mean_clearance},
    {"max_curvature", &Metrics::max_curvature},
    {"max_curvature_rate", &Metrics::max_curvature_rate},
    {"curvature_change", &Metrics::curvature_change},
    {"curvature_change_printed", &Metrics::curvature_change_printed},
    {"turning", &Metrics::turning},
    {"collision_risk", &Metrics::collision_risk},
    {"travel_time", &Metrics::travel_time},
};

/// All columns of the samples but `direction`, which holds whole numbers.
struct SampleColumn {
  const char* name;
  double Sample::*value;
};
inline constexpr SampleColumn sample_columns[] = {
    {"s", &Sample::s},           {"x", &Sample::x},
    {"y", &Sample::y},           {"heading", &Sample::heading},
    {"course", &Sample::course}, {"curvature", &Sample::curvature},
    {"t", &Sample::t},           {"speed", &Sample::speed},
};

constexpr const char* word_of(SplineKind kind) {
  return kind == SplineKind::natural_cubic ? "natural_cubic_spline" : "quintic_spline";
}

}  // namespace waywright
