// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/pipeline/observation_sink.hpp"

namespace echomap::pipeline {

/// Keeps what moves a robot's pose and map and what its scalar sensor said, so that a pipeline can
/// be given it again. Battery and yaw are left out: they are of the moment. Wherever the robot was
/// carried, a new stretch begins.
class ObservationLog final : public AnyObservationSink {
 public:
  void on(const sensors::Observation& observation) override;

  /// Hands it on in its order.
  void replay(ObservationSink& sink) const;

  /// How many it holds; where a scan begins, where it ends and where the robot was carried count.
  std::size_t observations() const;

  std::size_t scans() const;

  /// Of a robot that was carried off some time after the last scan that stays: takes off the last
  /// scans, so many or all there are since it was put down, with what came between and behind them.
  /// What came before the first of them is let go, for nobody knows where it was. The answer has a
  /// frame of its own, the robot's pose where it begins.
  ObservationLog split_off(std::size_t scans);
  /// Of a robot that was picked up: lets go what came since then, and a scan that was open. The
  /// answer begins where the robot is now.
  ObservationLog split_off_lift();

  /// Makes one log of two that have no time in common, in the frame of the one that began first.
  friend ObservationLog joined(ObservationLog one,
                               const ObservationLog& other,
                               const geometry::Pose2& T_one_other);

 private:
  using Event = sensors::Observation;
  /// What was sensed in one go, since the robot was put down.
  struct Stretch {
    std::optional<sensors::CarriedObservation> carried;  ///< Empty for the start of the first one.
    std::vector<Event> events;
  };

  template <class Kind>
  static bool is(const Event& event) {
    return std::holds_alternative<Kind>(event);
  }
  static bool is_lift(const Event& event);
  bool begins_before(const ObservationLog& other) const;
  static time::RobotTime begin_of(const Stretch& stretch);
  /// When the stretch ended, and how far the wheels had rolled; in a frame of its own.
  static sensors::CarriedObservation end_of(const Stretch& stretch);

  std::vector<Stretch> stretches_;
  bool scan_is_open_ = false;
};

}  // namespace echomap::pipeline
