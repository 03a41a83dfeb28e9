// SPDX-License-Identifier: MIT
#include "host/slam/bent_surfaces.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "host/slam/stop_stand.hpp"

namespace echomap::slam {

namespace {

/// A stop that is bent by less keeps the surfaces that were found in it.
constexpr double kBentRad = 0.012;
constexpr double kBentM = 0.005;
constexpr std::size_t kKeptBends = 8;

}  // namespace

const mapping::ScanSurfaces& BentSurfaces::find(const std::vector<geometry::Pose2>& T_first_stands,
                                                const mapping::Scan& readings,
                                                const mapping::SonarSurfaceParams& params) {
  auto same = std::find_if(found_.begin(), found_.end(), [&](const Bend& bend) {
    return are_near(T_first_stands, bend.T_first_stands, kBentM, kBentRad);
  });
  if (same == found_.end()) {
    if (found_.size() < kKeptBends) {
      found_.emplace_back();
    }
    found_.back() = {T_first_stands, find_surfaces(readings, params)};
    same = std::prev(found_.end());
  }
  std::rotate(found_.begin(), same, std::next(same));
  return last();
}

}  // namespace echomap::slam
