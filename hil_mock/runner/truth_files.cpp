// SPDX-License-Identifier: MIT
#include "hil_mock/runner/truth_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "hil_mock/runner/truth_map.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::runner {
namespace {

using nlohmann::json;

constexpr double kTruthCellM = 0.01;
constexpr double kUnoCyclesPerNs = 0.016;

std::int64_t uno_cycles(std::int64_t duration_ns) {
  return std::llround(static_cast<double>(duration_ns) * kUnoCyclesPerNs);
}

std::string tum_line(const TruthSample& sample) {
  const geometry::Pose2& pose = sample.T_world_robot;
  std::array<char, 160> line{};
  std::snprintf(line.data(),
                line.size(),
                "%.6f %.6f %.6f 0 0 0 %.9f %.9f\n",
                static_cast<double>(sample.at_ns) * 1e-9,
                pose.x_m(),
                pose.y_m(),
                std::sin(0.5 * pose.heading_rad()),
                std::cos(0.5 * pose.heading_rad()));
  return line.data();
}

/// Up to this instant, which an estimate may be of: samples are 20 ms apart.
std::string tum_text(const RobotSimulation& simulation) {
  std::string text;
  for (const TruthSample& sample : simulation.trajectory()) {
    text += tum_line(sample);
  }
  const std::int64_t now_ns = simulation.now_ns();
  if (simulation.trajectory().back().at_ns < now_ns) {
    text += tum_line({now_ns, simulation.world().T_world_robot()});
  }
  return text;
}

std::string pgm_bytes(const TruthMap& map) {
  std::string bytes =
      "P5\n" + std::to_string(map.width) + " " + std::to_string(map.height) + "\n255\n";
  for (int row = map.height - 1; row >= 0; --row) {
    for (int column = 0; column < map.width; ++column) {
      bytes.push_back(static_cast<char>(map.at(column, row)));
    }
  }
  return bytes;
}

std::string yaml_text(const TruthMap& map) {
  std::array<char, 256> text{};
  std::snprintf(text.data(),
                text.size(),
                "image: truth_map.pgm\nmode: trinary\nresolution: %.6g\n"
                "origin: [%.6g, %.6g, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n",
                map.resolution_m,
                map.origin_x_m,
                map.origin_y_m);
  return text.data();
}

json wall_feature(const world::Wall& wall) {
  const auto position = [](const Eigen::Vector2d& point_m) {
    return json{point_m.x(), point_m.y()};
  };
  return {{"type", "Feature"},
          {"properties", {{"material", world::name_of(wall.surface.material)}}},
          {"geometry",
           {{"type", "LineString"},
            {"coordinates", {position(wall.segment.from_m), position(wall.segment.to_m)}}}}};
}

std::string geojson_text(const world::FloorPlan& plan) {
  json features = json::array();
  for (const world::Wall& wall : plan.still_walls()) {
    features.push_back(wall_feature(wall));
  }
  return json{{"type", "FeatureCollection"}, {"features", features}}.dump(1) + "\n";
}

/// Positions in the world frame, and in that of the robot's start, as a map of its host has it.
std::string source_text(const world::FloorPlan& plan) {
  json sources = json::array();
  for (const world::Source& source : plan.sources()) {
    const Eigen::Vector2d map_m = plan.T_world_start().inverse() * source.position_m;
    sources.push_back({{"kind", world::name_of(source.kind)},
                       {"x_m", source.position_m.x()},
                       {"y_m", source.position_m.y()},
                       {"map_x_m", map_m.x()},
                       {"map_y_m", map_m.y()},
                       {"strength", source.strength},
                       {"height_m", source.height_m}});
  }
  const world::Backgrounds& backgrounds = plan.backgrounds();
  return json{{"background_per_s", backgrounds.radiation_per_s},
              {"ambient_lux", backgrounds.light_lux},
              {"sources", sources}}
             .dump(1) +
         "\n";
}

json stop_json(const StopReport& report) {
  json stop = {{"last_grant_ns", report.last_grant_ns}, {"stopped_after_ns", nullptr}};
  if (report.stopped_after_ns) {
    stop["stopped_after_ns"] = *report.stopped_after_ns;
    stop["stopped_after_cycles"] = uno_cycles(*report.stopped_after_ns);
  }
  return stop;
}

std::string summary_text(const RobotSimulation& simulation, const TruthSummary& summary) {
  const world::RobotWorld& world = simulation.world();
  const json text = {{"world", world.plan().name()},
                     {"robot", world.robot().name},
                     {"seed", summary.seed},
                     {"firmware", simulation.board().firmware_name()},
                     {"emulator", simulation.board().emulator_name()},
                     {"sim_seconds", static_cast<double>(simulation.now_ns()) / 1e9},
                     {"last_heard_ns", simulation.last_heard_ns()},
                     {"last_driven_ns", simulation.last_driven_ns()},
                     {"left_counts", world.body().left_wheel().counts()},
                     {"right_counts", world.body().right_wheel().counts()},
                     {"bumps", world.body().collisions().bumps},
                     {"hard_collisions", world.body().collisions().hard},
                     {"dropped_bytes", summary.dropped_bytes},
                     {"stop", summary.stop ? stop_json(*summary.stop) : json(nullptr)}};
  return text.dump(1) + "\n";
}

}  // namespace

void write_truth_so_far(const std::filesystem::path& directory, const RobotSimulation& simulation) {
  std::filesystem::create_directories(directory);
  const world::FloorPlan& plan = simulation.world().plan();
  const TruthMap map = draw_truth_map(plan, kTruthCellM);
  files::write_text_file(directory / "truth.tum", tum_text(simulation));
  files::write_text_file(directory / "truth_map.pgm", pgm_bytes(map));
  files::write_text_file(directory / "truth_map.yaml", yaml_text(map));
  files::write_text_file(directory / "truth_walls.geojson", geojson_text(plan));
  if (simulation.world().robot().parts.scalar || !plan.sources().empty()) {
    files::write_text_file(directory / "source.json", source_text(plan));
  }
}

void write_truth_files(const std::filesystem::path& directory,
                       const RobotSimulation& simulation,
                       const TruthSummary& summary) {
  write_truth_so_far(directory, simulation);
  files::write_text_file(directory / "truth.json", summary_text(simulation, summary));
}

std::string describe(const StopReport& report) {
  if (!report.stopped_after_ns) {
    return "the host vanished; the wheels were still driven two simulated seconds later";
  }
  return "the host vanished; the wheels stopped " +
         std::to_string(static_cast<double>(*report.stopped_after_ns) * 1e-9) + " s (" +
         std::to_string(uno_cycles(*report.stopped_after_ns)) + " CPU cycles) after its last grant";
}

}  // namespace echomap::runner
