// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "hil_mock/world/noise.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::runner {

/// A camera over the room that tells where the robot is; errors are standard deviations.
struct CameraParams {
  double rate_hz = 10.0;
  double delay_s = 0.1;   ///< From the picture to the fix, at least.
  double jitter_s = 0.0;  ///< And up to so much more, evenly; fixes overtake each other then.
  double noise_m = 0.01;  ///< Of x and of y.
  double noise_deg = 1.0;
  double drop = 0.0;  ///< Share of the pictures without a fix, 0 .. 1.
};

/// What "rate=10,delay=0.1,noise=0.01" says: rate, delay, jitter, noise, heading (degrees) and
/// drop, in any order; what is not named keeps its default. Throws std::invalid_argument.
CameraParams parse_camera(const std::string& text);

/// Takes pictures of a robot by a seed and tells fixes as lines of JSON (docs/guides/localize.md).
/// Its clock is the simulated time.
class OverheadCamera {
 public:
  /// Throws std::invalid_argument for parameters out of their ranges.
  OverheadCamera(const CameraParams& params, std::uint32_t seed);

  /// Takes a picture where one is due. Answers the lines that are sent at this instant; call it
  /// every millisecond or so.
  std::vector<std::string> look(std::int64_t now_ns, const geometry::Pose2& T_world_robot);

 private:
  struct Fix {
    std::int64_t sent_ns = 0;
    std::int64_t stamp_ns = 0;
    geometry::Pose2 T_world_robot;
  };

  void take_picture(std::int64_t now_ns, const geometry::Pose2& T_world_robot);
  std::string line_of(const Fix& fix) const;

  CameraParams params_;
  world::NoiseStream noise_;
  std::int64_t period_ns_;
  std::int64_t next_picture_ns_ = 0;
  std::deque<Fix> under_way_;  ///< The next to be sent first.
};

}  // namespace echomap::runner
