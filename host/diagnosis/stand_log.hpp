// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::diagnosis {

/// What both wheels have rolled, in metres by the profile, forward positive.
struct WheelStep {
  double left_m = 0.0;
  double right_m = 0.0;
};

/// What a robot heard while it stood, and where its wheels had come to.
struct Stand {
  std::size_t steps = 0;  ///< Wheel steps before it.
  std::size_t piece = 0;  ///< Of the way, on which nothing held the robot.
  /// Seen from the pan axis; bearings are pan angles by the profile.
  std::vector<mapping::SonarSurface> surfaces;
};

/// A range that the robot heard while its wheels rolled.
struct RollingPing {
  std::size_t steps = 0;  ///< Whole wheel steps before it.
  WheelStep rolled;       ///< Since then.
  std::size_t piece = 0;  ///< Of the way, as of a stand.
  /// Seen from the pan axis; the bearing is a pan angle by the profile.
  double bearing_rad = 0.0;
  double range_m = 0.0;
};

/// Wheel steps, stands and rolling pings of a robot's first stops, before anything is made of them.
/// Steps of one arc are joined.
class StandLog {
 public:
  StandLog(const sensors::RobotGeometry& robot, const mapping::SonarSurfaceParams& surfaces);

  void follow(const sensors::WheelTravel& travel);
  void begin_stop();
  void add(const sensors::SonarObservation& observation);
  void end_stop();
  /// Something has held the robot: what its wheels turned then is no way.
  void break_way();

  const sensors::RobotGeometry& robot() const { return robot_; }
  const std::vector<WheelStep>& steps() const { return steps_; }
  const std::vector<Stand>& stands() const { return stands_; }
  const std::vector<RollingPing>& rolling_pings() const { return rolling_pings_; }
  std::size_t stops() const { return stops_; }
  /// How far the robot has driven, turns left out.
  double travelled_m() const { return travelled_m_; }

 private:
  bool has_rolled_since_stand() const {
    return !steps_.empty() && (stands_.empty() || stands_.back().steps != steps_.size());
  }
  void end_stand();
  void add_rolling_pings(const mapping::Scan& heard);

  sensors::RobotGeometry robot_;
  mapping::SonarSurfaceParams surface_params_;
  std::optional<sensors::WheelTravel> last_;
  std::vector<WheelStep> steps_;
  std::vector<Stand> stands_;
  std::vector<RollingPing> rolling_pings_;
  mapping::Scan heard_;  ///< Since the wheels have moved.
  bool is_in_stop_ = false;
  std::size_t piece_ = 0;
  std::size_t stops_ = 0;
  double travelled_m_ = 0.0;
};

}  // namespace echomap::diagnosis
