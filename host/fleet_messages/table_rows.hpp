// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/fleet_messages/field_types.hpp"

namespace echomap::fleet_messages {

/// A pose in the plane.
struct PoseRow {
  static constexpr bool kIsRow = true;
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  std::uint16_t heading = 0;
  bool operator==(const PoseRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    visit("x_mm", self.x_mm);
    visit("y_mm", self.y_mm);
    visit("heading", self.heading);
  }
};

/// A slam::StopReading.
struct ReadingRow {
  static constexpr bool kIsRow = true;
  /// `range_mm` where there was no echo.
  static constexpr std::uint16_t kNoRange = 0xFFFF;
  PoseRow T_odom_robot;
  std::int32_t path_mm = 0;
  std::int32_t turn = 0;
  std::int32_t turned = 0;
  std::int32_t jumped_mm = 0;
  std::int32_t jumped = 0;
  std::int16_t sonar_x_mm = 0;
  std::int16_t sonar_y_mm = 0;
  std::uint16_t sonar_heading = 0;
  std::uint16_t range_mm = 0;
  bool operator==(const ReadingRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    PoseRow::fields(self.T_odom_robot, visit);
    visit("path_mm", self.path_mm);
    visit("turn", self.turn);
    visit("turned", self.turned);
    visit("jumped_mm", self.jumped_mm);
    visit("jumped", self.jumped);
    visit("sonar_x_mm", self.sonar_x_mm);
    visit("sonar_y_mm", self.sonar_y_mm);
    visit("sonar_heading", self.sonar_heading);
    visit("range_mm", self.range_mm);
  }
};

/// A team_map::SubmapContact.
struct ContactRow {
  static constexpr bool kIsRow = true;
  PoseRow T_odom_robot;
  std::uint8_t switches = 0;  ///< 1 left, 2 right, 3 both.
  bool operator==(const ContactRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    PoseRow::fields(self.T_odom_robot, visit);
    visit("switches", self.switches, std::uint64_t{3});
  }
};

/// A viewpoint that a robot claims.
struct ClaimRow {
  static constexpr bool kIsRow = true;
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  std::uint32_t utility_mm2_per_s = 0;
  std::uint16_t reach_mm = 0;
  bool operator==(const ClaimRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    visit("x_mm", self.x_mm);
    visit("y_mm", self.y_mm);
    visit("utility_mm2_per_s", self.utility_mm2_per_s);
    visit("reach_mm", self.reach_mm);
  }
};

/// A reading of a scalar sensor.
struct SourceRow {
  static constexpr bool kIsRow = true;
  std::uint32_t after_ms = 0;  ///< Since the message's `begin_ms`.
  PoseRow T_odom_robot;
  std::uint32_t value_milli = 0;  ///< Thousandths of a pulse or of the level's unit.
  std::uint32_t dwell_ms = 0;     ///< For how long pulses were counted; 0 for a level.
  bool operator==(const SourceRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    visit("after_ms", self.after_ms);
    PoseRow::fields(self.T_odom_robot, visit);
    visit("value_milli", self.value_milli);
    visit("dwell_ms", self.dwell_ms);
  }
};

/// A reading of a scalar sensor that a robot is about to take.
struct DwellRow {
  static constexpr bool kIsRow = true;
  std::int32_t x_mm = 0;
  std::int32_t y_mm = 0;
  std::uint32_t dwell_ms = 0;
  bool operator==(const DwellRow&) const = default;

  template <class M, class V>
  static constexpr void fields(M& self, V& visit) {
    visit("x_mm", self.x_mm);
    visit("y_mm", self.y_mm);
    visit("dwell_ms", self.dwell_ms);
  }
};

/// Covariance of a pose: standard deviations and correlations in 1/127. The largest standard
/// deviation represents larger ones, too.
struct CovariancePart {
  static constexpr bool kIsPart = true;
  std::uint16_t x_stddev_mm = 0;
  std::uint16_t y_stddev_mm = 0;
  std::uint16_t heading_stddev = 0;
  std::int8_t correlation_x_y = 0;
  std::int8_t correlation_x_heading = 0;
  std::int8_t correlation_y_heading = 0;
  bool operator==(const CovariancePart&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("x_stddev_mm", self.x_stddev_mm);
    visit("y_stddev_mm", self.y_stddev_mm);
    visit("heading_stddev", self.heading_stddev);
    visit("correlation_x_y", self.correlation_x_y);
    visit("correlation_x_heading", self.correlation_x_heading);
    visit("correlation_y_heading", self.correlation_y_heading);
  }
};

/// Pose of a robot's map in the frame of a component, and of its submaps as far as the component's
/// pose graph moves them against each other.
struct AlignedMapPart {
  static constexpr bool kIsPart = true;
  std::string robot;
  std::uint16_t map_number = 0;
  PoseRow T_component_map;
  std::vector<PoseRow> T_component_submaps;  ///< By index; empty: as by T_component_map.
  bool operator==(const AlignedMapPart&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("robot", self.robot);
    visit("map_number", self.map_number);
    PoseRow::fields(self.T_component_map, visit);
    visit("T_component_submaps", self.T_component_submaps);
  }
};

}  // namespace echomap::fleet_messages
