// SPDX-License-Identifier: MIT
#include "host/apps/explore_view.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "host/apps/run_ending.hpp"
#include "host/exports/run_directory.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {
namespace {

/// Of all maps.
std::size_t stops_in(const pipeline::RobotAtlas& atlas) {
  std::size_t stops = atlas.pipeline().snapshot().stops;
  for (const pipeline::PreviousMap& previous : atlas.previous_maps()) {
    stops += previous.pipeline.snapshot().stops;
  }
  return stops;
}

struct MotionWords {
  std::string operator()(const exploration::Turn& turn) const {
    return fmt::format("turns {:.0f}° to the {}",
                       std::abs(geometry::degrees(turn.angle_rad)),
                       turn.angle_rad < 0.0 ? "right" : "left");
  }
  std::string operator()(const exploration::Drive& drive) const {
    return fmt::format(
        "drives {:.2f} m{}", std::abs(drive.distance_m), drive.distance_m < 0.0 ? " back" : "");
  }
  std::string operator()(const exploration::Roll& /*roll*/) const { return "drives on"; }
  std::string operator()(const exploration::Sweep& /*sweep*/) const { return "sweeps its sonar"; }
  std::string operator()(const exploration::Stand& /*stand*/) const { return "stands"; }
  std::string operator()(const exploration::BeginScan& /*scan*/) const { return "scans"; }
  std::string operator()(const exploration::EndScan& /*scan*/) const { return "updates the map"; }
  std::string operator()(const exploration::BeginNewMap& /*map*/) const {
    return "starts a new map";
  }
  std::string operator()(const exploration::JoinMaps& /*maps*/) const {
    return "compares the map with the previous ones";
  }
  std::string operator()(const exploration::Finished& finished) const {
    return std::string("ended: ") + exploration::name_of(finished.reason);
  }
};

terminal_view::MapMarks marks_of(const pipeline::Snapshot& snapshot) {
  terminal_view::MapMarks marks;
  marks.T_map_robot = snapshot.latest.T_map_robot;
  for (const pipeline::StampedPose& pose : *snapshot.trajectory) {
    marks.trail_m.push_back(pose.T_map_robot.position_m());
  }
  return marks;
}

}  // namespace

std::string words_of(const exploration::Motion& motion) {
  return std::visit(MotionWords(), motion);
}

terminal_view::LinkHealth health_of(const robot_link::LinkStatistics& statistics) {
  terminal_view::LinkHealth link;
  if (statistics.round_trip) {
    link.round_trip_ms = std::chrono::duration<double, std::milli>(*statistics.round_trip).count();
  }
  link.frames_lost = statistics.frames_lost;
  link.frames_bad = statistics.frames_bad;
  link.resets = statistics.resets_seen;
  return link;
}

ExploreView::ExploreView(const session::RobotContext& robot,
                         const ExploreRun& run,
                         exploration::AtlasExplorer& explorer)
    : robot_(robot), run_(run), explorer_(explorer), stops_before_(stops_in(robot.atlas())) {}

exploration::Motion ExploreView::next(const pipeline::Snapshot& snapshot,
                                      exploration::MotionResult last) {
  exploration::Motion motion = explorer_.next(snapshot, last);
  doing_ = words_of(motion);
  look_at_stop(snapshot);
  return motion;
}

std::string ExploreView::line() { return line_of(progress(robot_.atlas().pipeline().snapshot())); }

terminal_view::RunView ExploreView::view() {
  const pipeline::Snapshot snapshot = robot_.atlas().pipeline().snapshot();
  const ExploreProgress so_far = progress(snapshot);
  terminal_view::RunStatus status;
  status.mode = "exploring by " + run_.strategy.name;
  status.doing = doing_;
  status.stops = so_far.stops;
  status.floor_m2 = so_far.floor_m2;
  status.coverage_share = coverage_ ? std::optional(coverage_->share()) : std::nullopt;
  status.page_url = run_.live.url();
  status.travelled_m = so_far.travelled_m;
  status.elapsed_s = so_far.elapsed_s;
  status.max_left_s = longest_left_s(so_far);
  describe_robot(snapshot, status);
  return {mapping::rasterize(*snapshot.grid), marks_of(snapshot), status};
}

double ExploreView::elapsed_s() const {
  return sim_seconds_of(run_.resumed) + now_s(robot_.session());
}

/// Of the whole map, as the summary is.
ExploreProgress ExploreView::progress(const pipeline::Snapshot& snapshot) const {
  exports::RunSummary summary;
  exports::describe_snapshot(snapshot, summary);
  const std::size_t stops_made = stops_before_ + explorer_.stops_made();
  ExploreProgress progress;
  progress.stops = summary.stops;
  progress.stops_elsewhere = stops_made - std::min(stops_made, summary.stops);
  progress.floor_m2 = summary.free_area_m2;
  progress.travelled_m = summary.travelled_m;
  progress.elapsed_s = elapsed_s();
  switch (strategies::limit_of(run_.strategy)) {
    case strategies::StrategyLimit::kStops:
      if (run_.strategy.stops) {
        progress.max_stops = stops_before_ + *run_.strategy.stops * run_.strategy.scans;
      }
      break;
    case strategies::StrategyLimit::kSeconds:
      progress.max_s = sim_seconds_of(run_.resumed) + run_.strategy.seconds;
      break;
    case strategies::StrategyLimit::kNone:
      break;
  }
  return progress;
}

void ExploreView::look_at_stop(const pipeline::Snapshot& snapshot) {
  const bool is_asked_for = run_.display == ProgressDisplay::kMap || run_.live.serves();
  if (!is_asked_for || std::exchange(covered_stops_, snapshot.stops) == snapshot.stops) {
    return;
  }
  coverage_ = coverage_of(snapshot, robot_.profile());
  run_.live.look();
}

LiveProgress ExploreView::live_progress() const {
  const ExploreProgress so_far = progress(robot_.atlas().pipeline().snapshot());
  return {so_far.stops,
          so_far.floor_m2,
          so_far.travelled_m,
          so_far.elapsed_s,
          longest_left_s(so_far),
          coverage_};
}

void ExploreView::describe_robot(const pipeline::Snapshot& snapshot,
                                 terminal_view::RunStatus& status) const {
  status.T_map_robot = snapshot.latest.T_map_robot;
  if (snapshot.position_stddev_m && snapshot.times_lifted == 0) {
    status.position_95_m = kStddevsOf95 * *snapshot.position_stddev_m;
  }
  status.link = health_of(robot_.session().link().statistics());
  if (snapshot.battery) {
    status.battery_v = snapshot.battery->voltage_v;
  }
}

}  // namespace echomap::apps
