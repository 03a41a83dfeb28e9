// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/diagnosis/fault_search.hpp"
#include "host/diagnosis/stand_log.hpp"
#include "host/diagnosis/wheel_check.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/pipeline/observation_sink.hpp"

namespace echomap::diagnosis {

/// When a robot is said to have a fault; ours, chosen in simulated rooms
/// (docs/algorithms/self_check.md).
struct SelfCheckParams {
  FaultSearchParams search;
  /// It is looked for after each of these stops, once the wheels have driven the robot so far.
  std::size_t first_stop = 2;
  std::size_t last_stop = 8;
  double min_travelled_m = 0.4;
  /// The robot with this fault explains what was heard better than a sound one, and than one with
  /// any other fault, by so much (log-likelihood).
  double min_log_odds = 5.5;
  double min_lead = 1.5;
  /// A sound robot that was measured by eye is off by nearly as much as one with wheels of another
  /// size, and curved or few surfaces look like a pan that is askew: to name these, it takes more.
  double min_subtle_log_odds = 7.0;
  /// A value that is off by less is not a fault: of wheels, of ranges and of the pan's zero.
  double min_wheel_error = 0.05;
  double min_range_error = 0.07;
  double min_pan_error_rad = 0.07;
};

/// A fault that a robot has.
struct Diagnosis {
  Fault fault;
  double log_odds = 0.0;  ///< Against a sound robot; infinite where wheels themselves show it.
  std::size_t stops = 0;  ///< After which it was found.
};

/// Compares wheels and sonar of a robot's first stops: a robot whose profile is right hears the
/// same walls wherever it goes. Ends where somebody lifts the robot. Wheels are compared with their
/// commands as long as there are motions.
class SelfCheck final : public pipeline::ObservationSink {
 public:
  SelfCheck(const sensors::RobotGeometry& robot,
            const mapping::SonarSurfaceParams& surfaces,
            const SelfCheckParams& params = {});

  void on_odometry(const sensors::OdometryObservation& observation) override;
  void on_sonar(const sensors::SonarObservation& observation) override;
  void on_hazards(const sensors::HazardObservation& observation) override;
  void on_carried(const sensors::CarriedObservation& observation) override;
  void begin_scan() override;
  void end_scan() override;

  /// Around each motion of the robot.
  void begin_motion(const exploration::Motion& motion) { wheels_.begin(motion); }
  void end_motion(exploration::MotionResult result);

  /// The first fault that was found.
  const std::optional<Diagnosis>& diagnosis() const { return diagnosis_; }
  /// The wheel that stood still when the last motion stalled.
  const std::optional<FaultKind>& stood_still() const { return wheels_.stood_still(); }

 private:
  SelfCheckParams params_;
  StandLog log_;
  WheelCheck wheels_;
  bool is_over_ = false;
  std::optional<Diagnosis> diagnosis_;
};

/// Of explanations as `explain` gives them; empty where none is sure enough.
std::optional<Diagnosis> diagnosis_of(const std::vector<Explanation>& explanations,
                                      const SelfCheckParams& params = {});

}  // namespace echomap::diagnosis
