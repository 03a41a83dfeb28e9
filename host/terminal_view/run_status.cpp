// SPDX-License-Identifier: MIT
#include "host/terminal_view/run_status.hpp"

#include <cmath>

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/terminal_view/text_line.hpp"

namespace echomap::terminal_view {
namespace {

using Facts = std::vector<std::string>;

std::string pose_fact(const RunStatus& status) {
  if (!status.T_map_robot) {
    return "position unsure";
  }
  const geometry::Pose2& robot = *status.T_map_robot;
  const std::string place = fmt::format("at {:.2f}, {:.2f} m, {:.0f}°",
                                        robot.x_m(),
                                        robot.y_m(),
                                        geometry::degrees(robot.heading_rad()));
  return place + (status.position_95_m
                      ? fmt::format(", ±{:.0f} cm (95 %)", std::ceil(100.0 * *status.position_95_m))
                      : ", unsure");
}

void add_action(const RunStatus& status, Facts& facts) {
  if (!status.mode.empty()) {
    facts.push_back(status.mode);
  }
  if (!status.doing.empty()) {
    facts.push_back(status.why.empty() ? status.doing : status.doing + ": " + status.why);
  }
}

void add_progress(const RunStatus& status, Facts& facts) {
  facts.push_back(fmt::format("{} stop{}", status.stops, status.stops == 1 ? "" : "s"));
  if (status.floor_m2) {
    facts.back() += fmt::format(", {:.1f} m² mapped", *status.floor_m2);
  }
  if (status.coverage_share) {
    facts.push_back(
        fmt::format("{:.0f} % of the floor in reach", std::floor(100.0 * *status.coverage_share)));
  }
  const std::string elapsed = minutes_text(status.elapsed_s);
  facts.push_back(status.travelled_m
                      ? fmt::format("{:.1f} m driven in {}", *status.travelled_m, elapsed)
                      : elapsed + " elapsed");
  if (status.max_left_s) {
    facts.push_back(minutes_text(*status.max_left_s) + " left at most");
  }
}

void add_robot(const RunStatus& status, Facts& facts) {
  if (status.link) {
    const LinkHealth& link = *status.link;
    facts.push_back(
        (link.round_trip_ms ? fmt::format("link {:.1f} ms", *link.round_trip_ms) : "link") +
        fmt::format(
            ", {} lost, {} bad, {} resets", link.frames_lost, link.frames_bad, link.resets));
  }
  if (status.battery_v) {
    facts.push_back(fmt::format("battery {:.1f} V", *status.battery_v));
  }
  if (!status.page_url.empty()) {
    facts.push_back(status.page_url);
  }
}

}  // namespace

std::vector<std::string> status_facts(const RunStatus& status, Glyphs glyphs) {
  Facts facts;
  add_action(status, facts);
  facts.push_back(pose_fact(status));
  add_progress(status, facts);
  add_robot(status, facts);
  for (std::string& fact : facts) {
    fact = printable(fact, glyphs);
  }
  return facts;
}

std::string minutes_text(double duration_s) {
  const auto seconds = std::lround(duration_s);
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace echomap::terminal_view
