// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/ekf_slam.hpp"

namespace echomap::slam {

/// How much of the way a filter keeps in its state.
struct KeptWayParams {
  /// A pose is kept every so often, for what is learnt later to correct the way up to there; where
  /// there are too many, every other one is let go and they are kept half as often.
  double kept_every_m = 1.0;
  double kept_every_rad = 0.5;
  std::size_t most_kept = 100;
};

/// The way of a filter's first robot: each instant hangs on a pose that the filter keeps.
class KeptWay {
 public:
  /// Throws std::invalid_argument for less than two poses kept.
  explicit KeptWay(const KeptWayParams& params = {});

  /// The robot's place in the filter is kept, where the last one that was is far.
  void keep(EkfSlam& filter);
  /// The next instant, when the robot was at `T_now_instant`, from where it was at the last `keep`.
  void add(const geometry::Pose2& T_now_instant);
  /// Where the robot was at each instant, as the filter knows it now.
  std::vector<geometry::Pose2> trajectory(const EkfSlam& filter) const;

 private:
  struct Instant {
    std::size_t kept = 0;
    geometry::Pose2 T_kept_robot;
  };

  void thin_out(EkfSlam& filter);

  KeptWayParams params_;
  double kept_every_ = 1.0;  ///< In units of the settings.
  Instant now_;
  std::vector<Instant> instants_;
};

}  // namespace echomap::slam
