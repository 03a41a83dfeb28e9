// SPDX-License-Identifier: MIT
#include "host/papers/epuck_ring.hpp"

#include <cmath>

#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::papers {

namespace {

constexpr double kRingPeriodS = 0.1;
constexpr double kCountsPerMillivolt = 1023.0 / 5000.0;

/// The curve that a user of the e-puck has in its profile.
sensors::InfraredCurve profile_curve() {
  const auto profile =
      files::TomlReader::load(files::bundled_file("epuck", "host/profiles", "robot profile"));
  std::vector<sensors::InfraredPoint> points;
  for (const auto& [counts, range_m] : profile.table("infrared").points("curve")) {
    points.push_back({counts, range_m});
  }
  return sensors::InfraredCurve(points);
}

world::RobotParams simulated_epuck() {
  return world::read_robot(
      files::TomlReader::load(files::bundled_file("epuck", "hil_mock/robots", "body")));
}

}  // namespace

EpuckRing::EpuckRing(const world::FloorPlan& field, std::uint32_t seed) : curve_(profile_curve()) {
  const world::RobotParams robot = simulated_epuck();
  for (const world::IrRangeParams& params : robot.parts.ranges) {
    const auto purpose = static_cast<std::uint32_t>(world::NoisePurpose::kRange0) +
                         static_cast<std::uint32_t>(params.channel);
    sensors_.emplace_back(
        field, params, world::NoiseStream(seed, static_cast<world::NoisePurpose>(purpose)));
  }
}

std::vector<localization::RangeReading> EpuckRing::read(const geometry::Pose2& T_world_robot) {
  std::vector<localization::RangeReading> readings;
  for (world::IrRange& sensor : sensors_) {
    sensor.step(kRingPeriodS, T_world_robot);
    const double counts = std::floor(kCountsPerMillivolt * sensor.millivolts());
    readings.push_back({sensor.params().T_robot_sensor, curve_.range_m(counts)});
  }
  return readings;
}

std::vector<geometry::Pose2> EpuckRing::places() const {
  std::vector<geometry::Pose2> T_robot_sensors;
  for (const world::IrRange& sensor : sensors_) {
    T_robot_sensors.push_back(sensor.params().T_robot_sensor);
  }
  return T_robot_sensors;
}

}  // namespace echomap::papers
