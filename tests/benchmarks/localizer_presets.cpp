// SPDX-License-Identifier: MIT
// How often the papers' filters and ours find a robot in the bundled rooms, with the same readings.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/localization/localizer_preset.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/room_runs.hpp"
#include "tests/support/expect_pose_estimate.hpp"

namespace echomap::bench {
namespace {

using localization::LocalizerPreset;

constexpr int kStops = 10;
/// Of HC-SR04's data sheet; that of the simulated robot is 13 degrees.
constexpr localization::LocalizedRobot kRobot{
    .beam_half_angle_rad = geometry::radians(15.0), .max_range_m = 4.0, .body_radius_m = 0.09};

struct NamedPreset {
  const char* name;
  LocalizerPreset preset;
};

/// Of the starts, how many end within 15 cm and 10 degrees after ten stops.
int found_in(const std::string& room, LocalizerPreset preset, int starts, std::uint32_t seed) {
  const auto model = localization::observation_model(preset, map_of_room(room), kRobot);
  int found = 0;
  for (int i = 0; i < starts; ++i) {
    const std::uint32_t own_seed = seed + static_cast<std::uint32_t>(i);
    RoomRobot robot(room, own_seed);
    localization::MonteCarloLocalizer localizer(
        *model, localization::localizer_params(preset, kRobot), std::mt19937(own_seed));
    for (int stop = 0; stop < kStops; ++stop) {
      if (stop > 0) {
        robot.drive();
      }
      localizer.update(robot.T_odom_robot(), robot.listen(8));
    }
    found += tests::is_estimated_near(
                 localizer.belief(), robot.T_map_robot(), 0.15, geometry::radians(10.0))
                 ? 1
                 : 0;
  }
  return found;
}

std::vector<Figure> preset_figures(int starts, std::uint32_t seed) {
  std::vector<Figure> figures;
  for (const auto& [name, preset] : {NamedPreset{"nxt", LocalizerPreset::kNxt},
                                     NamedPreset{"epuck", LocalizerPreset::kEpuck},
                                     NamedPreset{"default", LocalizerPreset::kDefault}}) {
    int all = 0;
    int found = 0;
    for (const char* const room : {"living_room", "l_room", "playground", "landing"}) {
      const int here = found_in(room, preset, starts, seed);
      fmt::print("{:8} {:12} found {} of {}\n", name, room, here, starts);
      found += here;
      all += starts;
    }
    figures.push_back({fmt::format("global_success_8_{}", name),
                       static_cast<double>(found) / all,
                       "1",
                       static_cast<std::size_t>(all),
                       {}});
  }
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  std::uint32_t seed = 1;
  int starts = 20;
  std::filesystem::path json;
  CLI::App app("How often the papers' filters and ours find a robot in the bundled rooms");
  app.add_option("--seed", seed, "First seed of robots and filters")->capture_default_str();
  app.add_option("--starts", starts, "Robots in each room")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::preset_figures(starts, seed), json);
}
