// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::slam {

/// Surfaces of one stop. They are found again only where its stands lie elsewhere to each other
/// than they did lately: an alignment from several starts bends a stop in as many ways, again and
/// again.
class BentSurfaces {
 public:
  /// Of readings in the frame of the first stand, where the stands are at `T_first_stands`.
  const mapping::ScanSurfaces& find(const std::vector<geometry::Pose2>& T_first_stands,
                                    const mapping::Scan& readings,
                                    const mapping::SonarSurfaceParams& params);

  /// As returned last; there must have been one.
  const mapping::ScanSurfaces& last() const { return found_.front().surfaces; }

 private:
  struct Bend {
    std::vector<geometry::Pose2> T_first_stands;
    mapping::ScanSurfaces surfaces;
  };

  std::vector<Bend> found_;  ///< The last one first.
};

}  // namespace echomap::slam
