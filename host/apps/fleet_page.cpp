// SPDX-License-Identifier: MIT
#include "host/apps/fleet_page.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "host/apps/fleet_watch.hpp"
#include "host/apps/served_page.hpp"
#include "host/apps/source_layer.hpp"
#include "host/fleet_member/search_view.hpp"
#include "host/fleet_messages/conversions.hpp"
#include "host/fleet_messages/payload.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/source_search/source_readings.hpp"

namespace echomap::apps {
namespace {

constexpr double kTrailStepM = 0.1;
constexpr double kSourcePeriodS = 3.0;

live_page::Presence presence_of(fleet::Attendance attendance) {
  switch (attendance) {
    case fleet::Attendance::kLeft:
      return live_page::Presence::kLeft;
    case fleet::Attendance::kGone:
      return live_page::Presence::kGone;
    case fleet::Attendance::kAlive:
      break;
  }
  return live_page::Presence::kAlive;
}

live_page::RunFacts facts_of(const std::filesystem::path& out) {
  live_page::RunFacts facts;
  facts.name = out.filename().string();
  facts.version = ECHOMAP_VERSION;
  facts.command = "fleet start";
  facts.live = true;
  return facts;
}

}  // namespace

FleetPage::FleetPage(const LiveOptions& options,
                     const session::RobotProfile& profile,
                     const std::filesystem::path& out) {
  if (!options.serves) {
    return;
  }
  publisher_ = std::make_shared<live_page::RunPublisher>(
      std::make_shared<live_page::History>(), facts_of(out), profile);
  server_ = serve_page(options, {{out.filename().string(), out, publisher_->history(), true}});
}

void FleetPage::hear(const std::vector<mqtt::Message>& messages) {
  if (!server_) {
    return;
  }
  for (const mqtt::Message& message : messages) {
    const auto decoded = fleet_messages::decode(message.topic, message.payload);
    const auto* told = std::get_if<fleet_messages::TopicMessage>(&decoded);
    if (told == nullptr || told->topic.kind != fleet_messages::TopicKind::kPose) {
      continue;
    }
    const auto& pose = std::get<fleet_messages::PoseMessage>(told->message.body);
    const Eigen::Vector2d at_m = fleet_messages::to_pose_estimate(pose).T_map_robot.position_m();
    auto& trail_m = trails_m_[fleet_member::map_name(told->topic.robot, pose.map_number)];
    if (trail_m.empty() || (trail_m.back() - at_m).norm() >= kTrailStepM) {
      trail_m.push_back(at_m);
    }
  }
}

live_page::TeamRobot FleetPage::shown(const fleet::FleetRobot& robot,
                                      const fleet_member::TeamPicture& picture,
                                      const std::string& map_name) const {
  live_page::TeamRobot shown;
  shown.name = robot.name;
  shown.presence = presence_of(robot.attendance);
  shown.radius_m = robot.traits.body_radius_m;
  for (const fleet::FleetMap& map : robot.maps) {
    shown.stops += map.record->submaps.size();
  }
  const auto relative = picture.relative_pose(map_name, robot);
  if (!robot.pose || robot.pose->map_number != robot.map_number) {
    return shown;
  }
  if (relative) {
    shown.T_map_robot = relative->T_own_peer * robot.pose->estimate.T_map_robot;
    const auto trail = trails_m_.find(fleet_member::map_name(robot.name, robot.map_number));
    if (trail != trails_m_.end()) {
      for (const Eigen::Vector2d& at_m : trail->second) {
        shown.trail_m.push_back(relative->T_own_peer * at_m);
      }
    }
    if (!robot.claims.empty() && robot.claims_map_number == robot.map_number) {
      shown.claim_m = relative->T_own_peer * robot.claims.front().at_m;
    }
  }
  return shown;
}

/// By all readings on the map of all, made anew every few seconds. Only what a robot is sure of is
/// sure: here it is not known what of the floor is unseen.
const std::optional<live_page::TeamSource>& FleetPage::source(double time_s,
                                                              const fleet::FleetState& state,
                                                              fleet_member::TeamPicture& picture,
                                                              const std::string& map_name) {
  const bool is_searched = std::any_of(
      state.robots.begin(), state.robots.end(), [](const auto& robot) { return robot.search; });
  const bool is_due = !source_revision_ || (*source_revision_ != state.revision &&
                                            time_s >= sourced_s_ + kSourcePeriodS);
  if (!is_searched || !is_due || picture.team().component_of(map_name) == nullptr) {
    return source_;
  }
  source_revision_ = state.revision;
  sourced_s_ = time_s;
  const auto view = fleet_member::search_view(
      state, picture, map_name, "", source_search::SourceReadingsParams().position_stddev_m);
  std::vector<source_search::FieldReading> readings;
  for (const fleet_member::SharedReading& shared : view.readings) {
    readings.push_back(shared.reading);
  }
  source_search::SourceBelief belief({}, mapping::rasterize(*picture.team().merged(map_name).grid));
  belief.add(readings);
  source_ = shown_source(belief);
  source_->verdict = "searching";
  if (view.finding) {
    source_->verdict = source_search::name_of(view.finding->report.verdict);
    source_->at_m = view.finding->at_m;
  }
  return source_;
}

void FleetPage::show(double time_s,
                     const fleet::FleetState& state,
                     fleet_member::TeamPicture& picture,
                     const std::string& map_name) {
  if (!server_) {
    return;
  }
  if (picture.team().component_of(map_name) != nullptr) {
    const auto& grid = picture.team().merged(map_name).grid;
    if (grid != grid_) {
      publisher_->map().look_at(time_s, *grid);
      grid_ = grid;
    }
  }
  live_page::TeamState team;
  for (const fleet::FleetRobot& robot : state.robots) {
    team.robots.push_back(shown(robot, picture, map_name));
  }
  team.source = source(time_s, state, picture, map_name);
  publisher_->add_team(time_s, team);
  live_page::RunState run;
  run.phase = live_page::RunState::Phase::kRunning;
  run.clients = server_->audience().clients;
  for (const live_page::TeamRobot& robot : team.robots) {
    run.stops += robot.stops;
  }
  publisher_->add_state(time_s, run);
}

void FleetPage::end(double time_s, const RunEnding& ending) {
  if (!server_) {
    return;
  }
  live_page::RunState run;
  run.phase = live_page::RunState::Phase::kEnded;
  run.result = live_page::RunResult{ending.finished(), ending.outcome, ending.why, ending.next};
  publisher_->add_state(time_s, run);
  wait_while_watched(*server_);
}

}  // namespace echomap::apps
