// SPDX-License-Identifier: MIT
#include "host/apps/demo_kidnap.hpp"

#include <chrono>

#include "host/apps/live_run.hpp"
#include "host/apps/localize_run.hpp"
#include "host/console/print.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/tracking/mcl_filter.hpp"
#include "host/tracking/pose_report.hpp"
#include "host/tracking/stop_driver.hpp"

namespace echomap::apps {
namespace {

constexpr std::size_t kMaxSearchStops = 10;
/// So many stops in a row that are sure of the place.
constexpr int kSureStops = 2;
constexpr std::chrono::seconds kHeld(2);
/// An explorer's own pose at the end.
constexpr double kStartStddevM = 0.1;
constexpr double kStartStddevRad = 0.1;

KidnapStop told_by(tracking::MclFilter& filter) {
  const localization::PoseBelief& belief = filter.localizer().belief();
  KidnapStop stop{
      belief.status, belief.lost_probability, std::nullopt, tracking::places_that_fit(belief)};
  if (!belief.hypotheses.empty()) {
    stop.told = filter.trajectory().back();
  }
  return stop;
}

/// Drives on until the place is sure.
void go_on(const FollowedRobot& followed, tracking::MclFilter& filter, DemoKidnap& kidnap) {
  int sure_stops = 0;
  while (kidnap.stops.size() < kMaxSearchStops && sure_stops < kSureStops &&
         follow_to_next_stop(followed)) {
    kidnap.stops.push_back(told_by(filter));
    const auto status = kidnap.stops.back().status;
    kidnap.is_noticed = kidnap.is_noticed || status == localization::LocalizationStatus::kLost ||
                        filter.localizer().times_lifted() > 0;
    const bool is_sure =
        kidnap.is_noticed && status == localization::LocalizationStatus::kLocalized;
    sure_stops = is_sure ? sure_stops + 1 : 0;
  }
}

}  // namespace

DemoKidnap show_kidnap(session::RobotContext& robot, LiveRun& live, const std::string& slam) {
  const auto snapshot = robot.atlas().pipeline().snapshot();
  const session::RobotProfile& profile = robot.profile();
  tracking::MclFilter filter(
      mapping::rasterize(*snapshot.grid),
      profile.geometry,
      tracking::localizer_params(profile, localization::LocalizerPreset::kDefault),
      tracking::StartPose{snapshot.latest.T_map_robot, kStartStddevM, kStartStddevRad},
      robot.seed().generator(session::SeedPurpose::kLocalizer));
  robot.fork().add(filter.sink());
  tracking::StopDriver driver(
      robot, slam, [&](const geometry::Pose2& goal) { return filter.telling(goal); });
  const FollowedRobot followed{robot, driver, filter};
  live.show(
      std::make_unique<FilterSource>(filter, std::nullopt, [&driver] { return driver.intent(); }),
      {.moved = [&filter] { filter.report_moved(); },
       .placed = [&filter](const geometry::Pose2& T_map_robot) { filter.place(T_map_robot); }});
  DemoKidnap kidnap;
  kidnap.explored = *snapshot.trajectory;

  console::print("localizing in its own map:");
  filter.begin(robot.session());
  if (follow_to_next_stop(followed)) {
    robot.lockstep()->carry_off(kHeld);
    live.tell({"carried-off",
               live_page::RunEvent::Level::kInfo,
               "somebody carries the robot off: it has to find its place in the map again"});
    console::print("carried to another place:");
    go_on(followed, filter, kidnap);
    kidnap.gave_up = driver.finished();
  }
  live.show_nothing();
  robot.session().disarm();
  robot.fork().remove(filter.sink());
  return kidnap;
}

}  // namespace echomap::apps
