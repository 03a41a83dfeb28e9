// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/diagnosis/fault.hpp"
#include "host/exploration/explorer.hpp"
#include "host/sensors/observations.hpp"

namespace echomap::diagnosis {

/// Compares what each wheel was told to do in a motion with what its encoder has counted.
class WheelCheck {
 public:
  void follow(const sensors::WheelTravel& travel) { travel_ = travel; }
  /// Whoever lifts the robot may turn its wheels.
  void lift() { is_in_the_air_ = true; }
  void begin(const exploration::Motion& motion);
  void end(exploration::MotionResult result);

  /// A wheel that has turned against its command: it drives the board's control astray, in every
  /// motion.
  const std::optional<FaultKind>& turned_against() const { return turned_against_; }
  /// The wheel that stood still if the last motion stalled: blocked, or not counted.
  const std::optional<FaultKind>& stood_still() const { return stood_still_; }

 private:
  /// Forward 1, backward -1.
  struct Directions {
    int left = 0;
    int right = 0;
  };

  sensors::WheelTravel travel_;
  sensors::WheelTravel before_;
  bool is_in_the_air_ = false;
  std::optional<Directions> told_;  ///< Empty for what drives no wheel.
  std::optional<FaultKind> turned_against_;
  std::optional<FaultKind> stood_still_;
};

}  // namespace echomap::diagnosis
