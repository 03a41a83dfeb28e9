// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/report.hpp"
#include "host/apps/whole_records.hpp"
#include "host/console/print.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/log_sweeps.hpp"
#include "host/sensors/incidence_noise.hpp"

namespace echomap::apps {
namespace {

using geometry::degrees;

constexpr double kIncidenceStepRad = geometry::radians(10.0);

constexpr double kThinnestRad = geometry::radians(2.0);

/// What a log says of its sonar.
struct SonarCharacter {
  std::size_t sweeps = 0;
  std::vector<sensors::SweptWall> walls;
  sensors::PooledBeamWidth beam_width;
  std::vector<sensors::IncidenceNoise> noise;
};

pipeline::LogSweeps read_sweeps(const CharacteriseOptions& options) {
  pipeline::LogSweeps sweeps;
  for (const auto& path : options.logs) {
    const auto log = open_reported_log(path, options.format);
    while (const auto record = next_whole_record(*log)) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      sweeps.add(*record);
    }
    sweeps.finish();
  }
  return sweeps;
}

[[noreturn]] void fail(const CharacteriseOptions& options, const std::string& what) {
  throw CommandError(ExitCode::kRuntimeError,
                     options.logs.front().string() +
                         (options.logs.size() > 1 ? " and others: " : ": ") + what +
                         "\n  next: let a robot sweep its sonar in steps of 3 to 6 degrees, from a "
                         "few places in a square room with bare walls");
}

SonarCharacter character_of(const CharacteriseOptions& options) {
  const pipeline::LogSweeps sweeps = read_sweeps(options);
  if (sweeps.sweeps().empty()) {
    fail(options,
         sweeps.laser_scans() > 0 ? "only scans of a laser, which has no cone"
                                  : "no sweep of a sonar");
  }
  sensors::WallBeamWidthParams params;
  params.range_stddev_m = options.range_stddev_m;
  SonarCharacter character;
  character.sweeps = sweeps.sweeps().size();
  for (const auto& sweep : sweeps.sweeps()) {
    const auto found = sensors::swept_walls(sweep, params);
    character.walls.insert(character.walls.end(), found.begin(), found.end());
  }
  const auto pooled = sensors::pooled_beam_width(character.walls);
  if (!pooled) {
    fail(options,
         fmt::format("{} sweeps show {} straight walls, but a beam width takes 3",
                     character.sweeps,
                     character.walls.size()));
  }
  if (pooled->mean.beam_width_rad < kThinnestRad) {
    fail(options, "its beams are as thin as a laser's, which has no cone");
  }
  character.beam_width = *pooled;
  character.noise = sensors::noise_by_incidence(character.walls, kIncidenceStepRad);
  return character;
}

/// To the tenth of a degree: the bounds are wider.
double suggested_half_angle_deg(const SonarCharacter& character) {
  return 0.1 * std::round(5.0 * degrees(character.beam_width.mean.beam_width_rad));
}

nlohmann::ordered_json json_of(const SonarCharacter& character) {
  const sensors::PooledBeamWidth& beam_width = character.beam_width;
  nlohmann::ordered_json json{
      {"sweeps", character.sweeps},
      {"walls", character.walls.size()},
      {"beam_width_deg", degrees(beam_width.mean.beam_width_rad)},
      {"beam_width_low_deg", degrees(beam_width.mean.low_rad)},
      {"beam_width_high_deg", degrees(beam_width.mean.high_rad)},
      {"beam_width_spread_deg", degrees(beam_width.spread_rad)},
      {"suggested_beam_half_angle_deg", suggested_half_angle_deg(character)},
      {"range_noise", nlohmann::ordered_json::array()}};
  for (const sensors::IncidenceNoise& row : character.noise) {
    json["range_noise"].push_back({{"incidence_from_deg", degrees(row.from_rad)},
                                   {"incidence_to_deg", degrees(row.to_rad)},
                                   {"readings", row.readings},
                                   {"bias_m", row.bias_m},
                                   {"stddev_m", row.stddev_m}});
  }
  return json;
}

void print(const SonarCharacter& character) {
  const sensors::PooledBeamWidth& beam_width = character.beam_width;
  console::print(fmt::format("{} walls in {} sweeps", character.walls.size(), character.sweeps));
  console::print(fmt::format(
      "  beam width {:.1f} +- {:.1f} degrees from wall to wall, mean between {:.1f} and {:.1f}",
      degrees(beam_width.mean.beam_width_rad),
      degrees(beam_width.spread_rad),
      degrees(beam_width.mean.low_rad),
      degrees(beam_width.mean.high_rad)));
  console::print("  incidence   readings   bias   stddev");
  for (const sensors::IncidenceNoise& row : character.noise) {
    console::print(fmt::format("  {:2.0f} .. {:2.0f} deg {:8d} {:7.1f} mm {:6.1f} mm",
                               degrees(row.from_rad),
                               degrees(row.to_rad),
                               row.readings,
                               1e3 * row.bias_m,
                               1e3 * row.stddev_m));
  }
  console::print(fmt::format("  for the profile's [sonar]: beam_half_angle_deg = {:.1f}",
                             suggested_half_angle_deg(character)));
}

}  // namespace

ExitCode run_characterise(const CharacteriseOptions& options) {
  const SonarCharacter character = character_of(options);
  print(character);
  write_report(options.json, json_of(character));
  return ExitCode::kOk;
}

}  // namespace echomap::apps
