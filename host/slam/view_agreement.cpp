// SPDX-License-Identifier: MIT
#include "host/slam/view_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echomap::slam {
namespace {

constexpr double kBesideBeamRad = 0.01;
constexpr double kMarginByRange = 0.05;

/// The least and the most range that beams next to a bearing measured; empty without any.
struct RangesBeside {
  double least_m = std::numeric_limits<double>::infinity();
  double most_m = 0.0;
};

RangesBeside ranges_beside(const RangeScan& scan, double bearing_rad) {
  const auto first = std::lower_bound(
      scan.beams.begin(),
      scan.beams.end(),
      bearing_rad - kBesideBeamRad,
      [](const RangeBeam& beam, double bearing) { return beam.bearing_rad < bearing; });
  RangesBeside beside;
  for (auto beam = first;
       beam != scan.beams.end() && beam->bearing_rad <= bearing_rad + kBesideBeamRad;
       ++beam) {
    if (beam->range_m) {
      beside.least_m = std::min(beside.least_m, *beam->range_m);
      beside.most_m = std::max(beside.most_m, *beam->range_m);
    }
  }
  return beside;
}

}  // namespace

ViewAgreement& ViewAgreement::operator+=(const ViewAgreement& other) {
  met += other.met;
  through += other.through;
  return *this;
}

double ViewAgreement::contradicted_share() const {
  const std::size_t seen = met + through;
  return seen == 0 ? 0.0 : static_cast<double>(through) / static_cast<double>(seen);
}

ViewAgreement view_agreement(const RangeScan& scan,
                             std::span<const Eigen::Vector2d> points_m,
                             double margin_m) {
  const geometry::Pose2 T_sensor_robot = scan.T_robot_sensor.inverse();
  ViewAgreement agreement;
  for (const Eigen::Vector2d& point_m : points_m) {
    const Eigen::Vector2d seen_m = T_sensor_robot * point_m;
    const double range_m = seen_m.norm();
    const RangesBeside beside = ranges_beside(scan, std::atan2(seen_m.y(), seen_m.x()));
    if (beside.most_m == 0.0) {
      continue;
    }
    const double allowed_m = margin_m + kMarginByRange * range_m;
    if (range_m < beside.least_m - allowed_m) {
      ++agreement.through;
    } else if (range_m < beside.most_m + allowed_m) {
      ++agreement.met;
    }
  }
  return agreement;
}

}  // namespace echomap::slam
