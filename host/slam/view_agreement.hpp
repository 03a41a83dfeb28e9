// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

/// What a scan says of points that stand somewhere according to others.
struct ViewAgreement {
  std::size_t met = 0;      ///< A beam ends there.
  std::size_t through = 0;  ///< A beam went on behind it: nothing can stand there.

  ViewAgreement& operator+=(const ViewAgreement& other);
  /// Share of the points that were looked at and cannot be; 0 where none was looked at.
  double contradicted_share() const;
};

/// Looks at points, in the robot's frame, along the beams of a scan. A point counts where a beam
/// with an answer passes within 1/100 rad; what stands behind the answer is hidden and does not
/// count. A range may be off by `margin_m` and a twentieth of itself: walls are seen at an angle.
ViewAgreement view_agreement(const sensors::RangeScan& scan,
                             std::span<const Eigen::Vector2d> points_m,
                             double margin_m);

}  // namespace echomap::slam
