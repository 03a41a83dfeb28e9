// SPDX-License-Identifier: MIT
#include "hil_mock/world/ir_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "hil_mock/world/ray_cast.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

constexpr double kSupplyMv = 5000.0;

/// A point of a sensor's curve.
struct CurvePoint {
  double range_m;
  double millivolts;
};

/// Sharp E4-A00201EN, figure "distance measuring characteristics": nearer than 6 cm the curve falls
/// again; beyond 0.8 m it flattens out.
constexpr std::array<CurvePoint, 19> kGp2y0a21Curve = {{{0.00, 0.0},
                                                        {0.02, 1450.0},
                                                        {0.04, 2650.0},
                                                        {0.06, 3150.0},
                                                        {0.07, 2950.0},
                                                        {0.08, 2700.0},
                                                        {0.10, 2300.0},
                                                        {0.12, 1980.0},
                                                        {0.15, 1640.0},
                                                        {0.20, 1300.0},
                                                        {0.25, 1070.0},
                                                        {0.30, 910.0},
                                                        {0.40, 740.0},
                                                        {0.50, 600.0},
                                                        {0.60, 510.0},
                                                        {0.70, 450.0},
                                                        {0.80, 400.0},
                                                        {1.00, 330.0},
                                                        {1.50, 220.0}}};

/// How a kind of sensor measures. Those of reflected light follow Benet et al. 2002, equation 4:
/// the inverse square of the range times reflectance and a power of the incidence's cosine.
struct Kind {
  std::span<const CurvePoint> curve;
  /// Without a curve: where the light has fallen to half of that at the sensor.
  double half_range_m;
  /// e-puck: Mahmood and Ridao 2017, section 4, see a wall only "almost perpendicular".
  double incidence_power;
  double beam_half_angle_rad;
  double period_s;
  double noise_mv;
};

constexpr Kind kGp2y0a21{kGp2y0a21Curve, 0.0, 0.0, geometry::radians(1.5), 0.0383, 12.0};
constexpr Kind kEpuck{{}, 0.010, 8.0, geometry::radians(5.0), 0.010, 10.0};
constexpr Kind kCreateWall{{}, 0.020, 2.0, geometry::radians(5.0), 0.015, 10.0};

const Kind& kind_of(IrKind kind) {
  switch (kind) {
    case IrKind::kEpuck:
      return kEpuck;
    case IrKind::kCreateWall:
      return kCreateWall;
    case IrKind::kGp2y0a21:
      break;
  }
  return kGp2y0a21;
}

double interpolated(std::span<const CurvePoint> curve, double range_m) {
  const auto next = std::find_if(
      curve.begin(), curve.end(), [&](const CurvePoint& point) { return point.range_m > range_m; });
  if (next == curve.end()) {
    return curve.back().millivolts;
  }
  const CurvePoint& from = *(next - 1);
  const double share = (range_m - from.range_m) / (next->range_m - from.range_m);
  return from.millivolts + share * (next->millivolts - from.millivolts);
}

}  // namespace

double ir_millivolts(IrKind kind, const IrTarget& target) {
  const Kind& sensor = kind_of(kind);
  if (!sensor.curve.empty()) {
    return interpolated(sensor.curve, target.range_m);
  }
  const double far = target.range_m / sensor.half_range_m;
  const double answer = target.reflectance / kPaperReflectance *
                        std::pow(std::cos(target.incidence_rad), sensor.incidence_power);
  return std::min(kSupplyMv, kSupplyMv * answer / (1.0 + far * far));
}

void IrRange::step(double dt_s, const geometry::Pose2& T_world_robot) {
  until_next_s_ -= dt_s;
  if (until_next_s_ > 0.0) {
    return;
  }
  const Kind& sensor = kind_of(params_.kind);
  until_next_s_ += sensor.period_s;
  millivolts_ = std::clamp(
      mean_millivolts(T_world_robot * params_.T_robot_sensor) + sensor.noise_mv * noise_.normal(),
      0.0,
      kSupplyMv);
}

/// Mean over the middle and both edges of the beam.
double IrRange::mean_millivolts(const geometry::Pose2& T_world_sensor) const {
  double sum_mv = 0.0;
  const double beam_half_angle_rad = kind_of(params_.kind).beam_half_angle_rad;
  for (const double off_axis_rad : {-beam_half_angle_rad, 0.0, beam_half_angle_rad}) {
    const double bearing_rad = T_world_sensor.heading_rad() + off_axis_rad;
    const auto hit = cast_ray(
        plan_, T_world_sensor.position_m(), {std::cos(bearing_rad), std::sin(bearing_rad)});
    const double share = hit ? light_back(hit->wall->surface, hit->incidence_rad) : 0.0;
    if (share > 0.0) {
      sum_mv += ir_millivolts(params_.kind, {hit->distance_m, share, hit->incidence_rad});
    }
  }
  return sum_mv / 3.0;
}

}  // namespace echomap::world
