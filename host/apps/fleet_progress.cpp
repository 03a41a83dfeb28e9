// SPDX-License-Identifier: MIT
#include "host/apps/fleet_progress.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "host/console/print.hpp"
#include "host/terminal_view/run_status.hpp"

namespace echomap::apps {

FleetProgress progress_of(const fleet::FleetState& state,
                          const fleet_member::TeamPicture& picture,
                          const std::string& first_map) {
  FleetProgress progress;
  std::size_t joined = 0;
  for (const fleet::FleetRobot& robot : state.robots) {
    std::size_t stops = 0;
    for (const fleet::FleetMap& map : robot.maps) {
      for (const team_map::Submap& submap : map.record->submaps) {
        progress.elapsed_s = std::max(progress.elapsed_s, submap.end_s);
        ++stops;
      }
    }
    joined += picture.relative_pose(first_map, robot) ? 1 : 0;
    const char* unit = progress.line.empty() ? (stops == 1 ? " stop" : " stops") : "";
    progress.line += fmt::format("{} {}{}, ", robot.name, stops, unit);
  }
  progress.line += fmt::format("{} of {} on one map, in {}",
                               joined,
                               state.robots.size(),
                               terminal_view::minutes_text(progress.elapsed_s));
  return progress;
}

void FleetProgressPrinter::print(const FleetProgress& progress) {
  if (progress.elapsed_s >= next_line_s_) {
    next_line_s_ = progress.elapsed_s + 30.0;
    console::print(progress.line);
  }
}

}  // namespace echomap::apps
