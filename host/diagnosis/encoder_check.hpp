// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "host/diagnosis/fault.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::diagnosis {

/// When an encoder is said to be dirty. A clean one has no errors at all, up to the board's limit
/// (docs/guides/faults.md); a spark of a motor now and then is no dirt, and one count in 200 bends
/// the way less than wheels that were measured by eye.
struct EncoderCheckParams {
  /// The errors of so long count.
  time::RobotClock::duration window = std::chrono::seconds(10);
  /// So many errors at least,
  std::int64_t min_errors = 10;
  /// which lose such a share of the wheel's counts.
  double min_lost_share = 0.005;
};

/// Compares the errors that the board counts at each encoder with what that wheel has rolled.
class EncoderCheck final : public pipeline::ObservationSink {
 public:
  explicit EncoderCheck(const sensors::RobotGeometry& robot, const EncoderCheckParams& params = {});

  void on_odometry(const sensors::OdometryObservation& observation) override;
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void on_encoder_errors(const sensors::EncoderErrorObservation& observation) override;
  void begin_scan() override {}
  void end_scan() override {}

  /// The first that was found: kLeftDirty or kRightDirty, with the share of its counts that is
  /// lost.
  const std::optional<Fault>& fault() const { return fault_; }

 private:
  struct Wheel {
    std::int64_t errors = 0;
    double counts = 0.0;  ///< Both ways together.
  };
  struct Sample {
    time::RobotTime stamp;
    Wheel left;
    Wheel right;
  };

  /// The share of a wheel's counts that is lost; 0 where there are few errors.
  double lost_share(const Wheel& before, const Wheel& now) const;

  double metres_per_tick_;
  EncoderCheckParams params_;
  std::optional<sensors::WheelTravel> travel_;
  double left_counts_ = 0.0;
  double right_counts_ = 0.0;
  std::deque<Sample> samples_;  ///< Of the window, the oldest first.
  std::optional<Fault> fault_;
};

/// Whether a wheel that loses counts explains what the first stops have shown.
bool explains(const Fault& dirt, FaultKind shown);

}  // namespace echomap::diagnosis
