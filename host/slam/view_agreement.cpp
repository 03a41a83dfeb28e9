// SPDX-License-Identifier: MIT
#include "host/slam/view_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

constexpr double kBesideBeamRad = 0.01;
constexpr double kMarginByRange = 0.05;

/// The least and the most range that beams next to a bearing measured; empty without any.
struct RangesBeside {
  double min_m = std::numeric_limits<double>::infinity();
  double max_m = 0.0;
};

/// The beams with an answer in the order of their bearings, all the way round.
class AnswersByBearing {
 public:
  explicit AnswersByBearing(const sensors::RangeScan& scan) {
    constexpr double kRound = 2.0 * std::numbers::pi;
    for (const sensors::Beam& beam : scan.beams) {
      if (!beam.range_m) {
        continue;
      }
      const double bearing_rad = geometry::wrap_angle(beam.bearing_rad);
      answers_.push_back({bearing_rad, *beam.range_m});
      // Beside a beam at one end of the circle lie those at the other.
      if (std::abs(bearing_rad) > std::numbers::pi - kBesideBeamRad) {
        answers_.push_back({bearing_rad - std::copysign(kRound, bearing_rad), *beam.range_m});
      }
    }
    std::sort(answers_.begin(), answers_.end(), [](const Answer& one, const Answer& other) {
      return one.bearing_rad < other.bearing_rad;
    });
  }

  RangesBeside beside(double bearing_rad) const {
    auto answer =
        std::lower_bound(answers_.begin(),
                         answers_.end(),
                         bearing_rad - kBesideBeamRad,
                         [](const Answer& one, double least) { return one.bearing_rad < least; });
    RangesBeside beside;
    for (; answer != answers_.end() && answer->bearing_rad <= bearing_rad + kBesideBeamRad;
         ++answer) {
      beside.min_m = std::min(beside.min_m, answer->range_m);
      beside.max_m = std::max(beside.max_m, answer->range_m);
    }
    return beside;
  }

 private:
  struct Answer {
    double bearing_rad = 0.0;
    double range_m = 0.0;
  };

  std::vector<Answer> answers_;
};

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

ViewAgreement view_agreement(const sensors::RangeScan& scan,
                             std::span<const Eigen::Vector2d> points_m,
                             double margin_m) {
  const geometry::Pose2 T_sensor_robot = scan.T_robot_sensor.inverse();
  const AnswersByBearing answers(scan);
  ViewAgreement agreement;
  for (const Eigen::Vector2d& point_m : points_m) {
    const Eigen::Vector2d seen_m = T_sensor_robot * point_m;
    const double range_m = seen_m.norm();
    const RangesBeside beside = answers.beside(std::atan2(seen_m.y(), seen_m.x()));
    if (beside.max_m == 0.0) {
      continue;
    }
    const double allowed_m = margin_m + kMarginByRange * range_m;
    if (range_m < beside.min_m - allowed_m) {
      ++agreement.through;
    } else if (range_m < beside.max_m + allowed_m) {
      ++agreement.met;
    }
  }
  return agreement;
}

}  // namespace echomap::slam
