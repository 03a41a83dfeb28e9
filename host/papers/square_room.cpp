// SPDX-License-Identifier: MIT
#include "host/papers/square_room.hpp"

#include <numbers>

#include "hil_mock/world/robot_file.hpp"
#include "hil_mock/world/sonar_physics.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::papers {

world::SonarParams ev3_sonar(double beam_width_rad) {
  auto params = world::read_robot(
                    files::TomlReader::load(files::bundled_file("ev3", "hil_mock/robots", "body")))
                    .sonar;
  params.beam_half_angle_rad = 0.5 * beam_width_rad;
  return params;
}

world::FloorPlan square_room() {
  const std::vector<world::Surface> rough(4, {world::Material::kRough, 0.9});
  return {"square", {{{-0.6, -0.7}, {0.8, -0.7}, {0.8, 0.7}, {-0.6, 0.7}}, rough}, {}, {}};
}

std::vector<sensors::Beam> sweep(const world::FloorPlan& room,
                                 const world::SonarParams& sonar,
                                 const SweepSteps& steps,
                                 std::uint32_t seed) {
  const world::SonarPhysics physics(room, sonar);
  world::NoiseStream noise(seed, world::NoisePurpose::kSonar);
  std::vector<sensors::Beam> readings;
  for (double bearing_rad = -steps.half_rad; bearing_rad < steps.half_rad;
       bearing_rad += steps.step_rad) {
    readings.push_back({bearing_rad, physics.ping_m({0.0, 0.0, bearing_rad}, noise)});
  }
  return readings;
}

std::vector<sensors::SweptWall> walls_of_room(const world::FloorPlan& room,
                                              const world::SonarParams& sonar,
                                              std::uint32_t seed) {
  constexpr std::uint32_t kTurns = 4;
  constexpr std::uint32_t kSeedsApart = 20;
  sensors::WallBeamWidthParams params;
  params.range_stddev_m = 0.01;
  std::vector<sensors::SweptWall> walls;
  for (std::uint32_t turn = 0; turn < kTurns; ++turn) {
    const auto readings =
        sweep(room, sonar, {std::numbers::pi, geometry::radians(3.0)}, seed + turn * kSeedsApart);
    const auto found = sensors::swept_walls(readings, params);
    walls.insert(walls.end(), found.begin(), found.end());
  }
  return walls;
}

}  // namespace echomap::papers
