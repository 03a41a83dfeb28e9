// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace echomap::localization {

/// What a heading filter expects of gyro and wheels; ours, for an MPU-6050 on a small robot.
struct HeadingFilterParams {
  double start_heading_stddev_rad = 0.01;
  /// A gyro that nobody has calibrated: 3 degrees a second (MPU-6050's data sheet says 20).
  double start_bias_stddev_rad_per_s = 0.05;
  /// Random walks of heading and bias, by the root of the time.
  double gyro_rad_per_root_s = 1e-3;
  double bias_rad_per_s_per_root_s = 1e-4;
  /// The wheels' turn is off by that share of it, and by that much anyway, as wheels that slip.
  double wheel_turn_share = 0.1;
  double wheel_floor_rad = 2e-3;
  /// And by that much times the root of what they have rolled ahead: for steps of a whole move,
  /// where the floor, which is one step's, says too little.
  double wheel_rad_per_root_m = 0.0;
  /// The wheels are not believed where gyro and bias say otherwise by more than this, squared:
  /// 99.9 % of chi square with one degree of freedom.
  double gate = 10.83;
};

/// What gyro and wheels have turned since the last update, counter-clockwise.
struct HeadingStep {
  double duration_s = 0.0;
  double gyro_turn_rad = 0.0;  ///< Its bias included.
  double wheel_turn_rad = 0.0;
  double forward_m = 0.0;  ///< Either way.
};

/// What has become of a step.
enum class HeadingOutcome : std::uint8_t {
  kApplied,
  kWheelsSlipped,  ///< By the gyro alone, as the wheels say something else.
  kBadTime,        ///< Refused: a duration that is not above 0.
  kNotFinite,      ///< Refused.
};

/// Heading and bias of the gyro by a Kalman filter (Hennessey et al., section II.C, name the filter
/// and the gyro and give no equations). The gyro foretells the turn; the wheels measure that turn,
/// well where they hardly turn, so that a robot that stands calibrates its gyro:
///
///     heading' = heading + gyro - bias dt,   wheels = heading' - heading + slip.
class HeadingFilter {
 public:
  /// Throws std::invalid_argument for a negative or infinite setting.
  explicit HeadingFilter(const HeadingFilterParams& params = {});

  HeadingOutcome update(const HeadingStep& step);

  /// In (-pi, pi], from where it started.
  double heading_rad() const { return heading_rad_; }
  double bias_rad_per_s() const { return bias_rad_per_s_; }
  /// Of heading and bias.
  const Eigen::Matrix2d& covariance() const { return covariance_; }

 private:
  HeadingFilterParams params_;
  double heading_rad_ = 0.0;
  double bias_rad_per_s_ = 0.0;
  Eigen::Matrix2d covariance_;
};

}  // namespace echomap::localization
