// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <random>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// Mukherjee et al., section V, give no values; these are ours.
struct RandomBounceParams {
  double tick_s = 0.07;
  double speed_m_per_s = 0.20;
  double spin_rad_per_s = 1.5;
  /// A turn to the left is drawn evenly between these: away from what was met.
  double min_turn_rad = 1.5707963267948966;
  double max_turn_rad = 4.71238898038469;
  /// End after so long a time or so long a way.
  double max_s = 120.0;
  double max_distance_m = 1000.0;
};

/// Strategy `random-bounce`, the drive under which Mukherjee et al. localize (section V: "moves in
/// a random manner"): straight until a bump or a virtual wall, a random turn, and on.
class RandomBounce final : public Explorer {
 public:
  /// Keeps a reference to `random`. Throws std::invalid_argument for invalid parameters.
  RandomBounce(const RandomBounceParams& params, std::mt19937& random);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

 private:
  bool is_over(const pipeline::StampedPose& now);

  RandomBounceParams params_;
  std::mt19937& random_;
  std::optional<pipeline::StampedPose> first_;
  pipeline::StampedPose last_;
  double travelled_m_ = 0.0;
};

}  // namespace echomap::exploration
