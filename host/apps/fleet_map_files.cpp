// SPDX-License-Identifier: MIT
#include "host/apps/fleet_map_files.hpp"

#include <fmt/format.h>

#include "host/apps/saved_map.hpp"
#include "host/exports/run_directory.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::apps {
namespace {

std::string names_of(const team_map::MergedMap& merged, std::uint64_t robots) {
  std::string names;
  for (std::size_t i = 0; i < merged.robots.size(); ++i) {
    if ((robots >> i & 1U) != 0) {
      names += (names.empty() ? "" : "+") + merged.robots[i];
    }
  }
  return names;
}

}  // namespace

void save_team_map(const pipeline::Snapshot& snapshot,
                   const session::RobotProfile& profile,
                   const std::filesystem::path& folder,
                   exports::RunSummary summary) {
  std::filesystem::create_directories(folder);
  exports::RunDrawing drawing;
  if (profile.body_radius_m > 0.0) {
    drawing.robot_radius_m = profile.body_radius_m;
  }
  exports::describe_snapshot(snapshot, summary);
  files::write_text_file(folder / kProfileName, profile.toml);
  exports::write_run_directory(folder, snapshot, summary, drawing);
}

void save_provenance(const team_map::MergedMap& merged, const std::filesystem::path& file) {
  const mapping::CellBounds& bounds = merged.provenance.bounds();
  std::string text = "x_m,y_m,robots\n";
  for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const std::uint64_t robots =
          bounds.empty() ? 0 : merged.provenance.robots_at(geometry::CellIndex{x, y});
      if (robots != 0) {
        const Eigen::Vector2d at_m = merged.grid->center_m({x, y});
        text += fmt::format("{:.3f},{:.3f},{}\n", at_m.x(), at_m.y(), names_of(merged, robots));
      }
    }
  }
  files::write_text_file(file, text);
}

void save_team_map(fleet_member::FleetMember& member,
                   const session::RobotProfile& profile,
                   const std::filesystem::path& folder,
                   const exports::RunSummary& summary) {
  save_team_map(member.known(), profile, folder, summary);
  if (const team_map::MergedMap* merged = member.merged()) {
    save_provenance(*merged, folder / "provenance.csv");
  }
}

}  // namespace echomap::apps
