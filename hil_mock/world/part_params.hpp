// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// Kinds of infra-red range sensors; their curves stand in ir_range.cpp.
enum class IrKind : std::uint8_t {
  kGp2y0a21,    ///< Sharp GP2Y0A21YK0F, triangulation, 0.1 .. 0.8 m.
  kEpuck,       ///< The e-puck's ring: reflected light, 0 .. 0.06 m.
  kCreateWall,  ///< The iRobot Create's wall sensor: reflected light, 0 .. 0.1 m.
};

/// One infra-red range channel.
struct IrRangeParams {
  /// 0 .. 7, as in protocol::Ranges.
  int channel = 0;
  IrKind kind = IrKind::kGp2y0a21;
  geometry::Pose2 T_robot_sensor;
};

/// Where a cliff sensor sits, seen from behind the robot.
enum class CliffPlace : std::uint8_t { kLeft, kFrontLeft, kFrontRight, kRight };

/// A sensor that looks down on the floor.
struct CliffParams {
  CliffPlace place = CliffPlace::kLeft;
  Eigen::Vector2d mount_m = Eigen::Vector2d::Zero();
};

/// An infra-red switch that sees a wall within its reach.
struct WallSensorParams {
  geometry::Pose2 T_robot_sensor;
  /// To a wall of white paint; the reach to a darker one goes with the root of its reflectance.
  double reach_m = 0.1;
};

/// A detector of virtual walls that looks all around.
struct BeamDetectorParams {
  Eigen::Vector2d mount_m = Eigen::Vector2d::Zero();
  /// Of a virtual wall's emitter that is mounted on the robot and looks ahead, so that the detector
  /// sees its light on a wall (Mukherjee et al., section III and figure 4); 0 for none.
  double own_beam_reach_m = 0.0;
  double own_beam_half_angle_rad = 0.0;
};

/// A rate gyro about the vertical axis. The defaults are those of an MPU-6050 (InvenSense
/// PS-MPU-6000A rev. 3.4, table 6.1).
struct GyroParams {
  /// Standard deviations over runs: zero-rate output, data sheet +-20 at most; scale factor, +-3 %
  /// tolerance taken as three of them.
  double bias_stddev_deg_per_s = 2.0;
  double scale_stddev = 0.01;
  /// Random walk of the bias: standard deviation after one second.
  double bias_walk_deg_per_s_per_sqrt_s = 0.002;
  double noise_deg_per_s_per_sqrt_hz = 0.005;
};

/// A battery, what the robot draws from it, and the divider to the converter's pin.
struct BatteryParams {
  /// Without load, full and empty; between the two the voltage falls in a straight line.
  double full_v = 8.4;
  double empty_v = 6.4;
  double capacity_ah = 2.0;
  double resistance_ohm = 0.15;
  /// Electronics; a motor that stands still at full duty; a motor that turns freely.
  double idle_a = 0.15;
  double stall_a = 1.5;
  double no_load_a = 0.12;
  /// Voltage at the pin for one volt of the battery.
  double divider = 0.5;
  /// Standard deviation at the pin.
  double noise_mv = 3.0;
};

/// A pan drive by a unipolar stepper motor in half steps. The defaults are those of a 28BYJ-48
/// with its gear of 63.684 to 1 and 64 half steps.
struct StepperParams {
  /// Of the pan; negative where the order A, B, C, D of its coils turns it right.
  double half_steps_per_turn = 4075.77;
  /// The fastest that its rotor follows from rest: data sheet of the 28BYJ-48, "in-traction
  /// frequency > 600 Hz".
  double max_half_steps_per_s = 600.0;
};

/// Kinds of sensors that say one number.
enum class ScalarSensorKind : std::uint8_t {
  kGeiger,  ///< A tube and its circuit: pulses, low for a while.
  kLight,   ///< A photo transistor with a resistor: a voltage.
};

/// A sensor that says one number, at a place on the robot. The tube's dead time is that of an
/// SBM-20 at 400 V by its data sheet; the pulse is what a common circuit makes of it.
struct ScalarSensorParams {
  ScalarSensorKind kind = ScalarSensorKind::kGeiger;
  Eigen::Vector2d mount_m = Eigen::Vector2d::Zero();
  /// Pulses per second for each of a source's strength, or millivolts per lux.
  double sensitivity = 1.0;
  /// Of a tube: for so long after a pulse it notices nothing, and the pin is low.
  double dead_time_s = 190e-6;
  double pulse_s = 150e-6;
  /// Of a light sensor: in the dark, and standard deviation of each conversion.
  double dark_millivolts = 50.0;
  double noise_millivolts = 10.0;
};

/// What a robot may carry beside wheels, bumpers, sonar and pan servo.
struct PartParams {
  std::vector<IrRangeParams> ranges;
  std::vector<CliffParams> cliffs;
  std::optional<WallSensorParams> wall;
  std::optional<BeamDetectorParams> beam_detector;
  std::optional<GyroParams> gyro;
  std::optional<BatteryParams> battery;
  /// In place of the pan servo.
  std::optional<StepperParams> stepper;
  std::optional<ScalarSensorParams> scalar;
};

}  // namespace echomap::world
