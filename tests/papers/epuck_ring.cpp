// SPDX-License-Identifier: MIT
#include "tests/papers/epuck_ring.hpp"

#include <cmath>
#include <string>

#include "hil_mock/world/robot_file.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::papers {

namespace {

constexpr double kPeriodS = 0.1;
constexpr double kCountsPerMillivolt = 1023.0 / 5000.0;

files::TomlReader bundled(const std::string& file) {
  return files::TomlReader::load(std::string(ECHOMAP_SOURCE_DIR) + "/" + file);
}

/// The curve that a user of the e-puck has in its profile.
sensors::InfraredCurve profile_curve() {
  std::vector<sensors::InfraredPoint> points;
  for (const auto& [counts, range_m] :
       bundled("host/profiles/epuck.toml").table("infrared").points("curve")) {
    points.push_back({counts, range_m});
  }
  return sensors::InfraredCurve(points);
}

}  // namespace

EpuckRing::EpuckRing(const world::FloorPlan& field, std::uint32_t seed) : curve_(profile_curve()) {
  const auto robot = world::read_robot(bundled("hil_mock/robots/epuck.toml"));
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
    sensor.step(kPeriodS, T_world_robot);
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
