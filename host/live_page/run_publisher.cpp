// SPDX-License-Identifier: MIT
#include "host/live_page/run_publisher.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "host/live_page/server_clock.hpp"

namespace echomap::live_page {
namespace {

using nlohmann::ordered_json;

/// A state that differs in what changes all the time is told so often.
constexpr double kStatePeriodS = 1.0;
constexpr double kLogitsPerStep = 0.01 * mapping::kStepCentilogits;

ordered_json sonar_of(const session::RobotProfile& profile) {
  if (!profile.has_sonar) {
    return nullptr;
  }
  return {{"x_m", profile.geometry.sonar_x_m},
          {"y_m", profile.geometry.sonar_y_m},
          {"half_angle_rad", profile.beam_half_angle_rad},
          {"max_range_m", profile.range.max_range_m}};
}

ordered_json hello_of(const RunFacts& facts, const session::RobotProfile& profile) {
  const mapping::OccupancyGridParams grid;
  return {{"version", facts.version},
          {"run", facts.id},
          {"name", facts.name},
          {"command", facts.command},
          {"live", facts.live},
          {"robot", profile.name},
          {"radius_m", profile.body_radius_m},
          {"resolution_m", grid.resolution_m},
          {"step_logits", kLogitsPerStep},
          {"free_below", grid.free_threshold},
          {"occupied_above", grid.occupied_threshold},
          {"sonar", sonar_of(profile)},
          {"can", facts.can},
          {"has_truth", facts.has_truth}};
}

PingResult result_of(const sensors::SonarObservation& ping) {
  if (!ping.has_answered) {
    return PingResult::kNoAnswer;
  }
  return ping.range_m ? PingResult::kEcho : PingResult::kSilence;
}

const char* name_of(RunEvent::Level level) {
  switch (level) {
    case RunEvent::Level::kWarning:
      return "warning";
    case RunEvent::Level::kError:
      return "error";
    case RunEvent::Level::kInfo:
      break;
  }
  return "info";
}

}  // namespace

RunPublisher::RunPublisher(std::shared_ptr<History> history,
                           const RunFacts& facts,
                           const session::RobotProfile& profile)
    : history_(std::move(history)), map_(history_), hello_(hello_of(facts, profile)) {
  history_->add(json_message(MessageKind::kHello, 0.0, hello_));
}

void RunPublisher::set_can(double time_s, std::vector<std::string> can) {
  hello_["can"] = std::move(can);
  history_->add(json_message(MessageKind::kHello, time_s, hello_));
}

void RunPublisher::on(const sensors::Observation& observation) {
  if (const auto* ping = std::get_if<sensors::SonarObservation>(&observation)) {
    ping_ = {ping->pan_rad, ping->range_m, ping_.number + 1, result_of(*ping)};
  } else if (const auto* battery = std::get_if<sensors::BatteryObservation>(&observation)) {
    battery_v_ = battery->voltage_v;
  } else if (const auto* hazards = std::get_if<sensors::HazardObservation>(&observation)) {
    hazards_ = *hazards;
  }
}

void RunPublisher::add_motion(double time_s,
                              const pipeline::PoseEstimate& pose,
                              const std::optional<geometry::Pose2>& T_map_true_robot) {
  history_->add(motion_message(time_s,
                               {server_clock_ms(),
                                pose.T_map_robot,
                                pose.covariance,
                                pose.T_odom_robot,
                                T_map_true_robot,
                                ping_}));
}

void RunPublisher::add_particles(double time_s, const std::vector<WeightedPose>& particles) {
  history_->add(particles_message(time_s, particles));
}

void RunPublisher::add_state(double time_s, const RunState& state) {
  const auto json = to_json(state);
  auto lasting = json;
  for (const char* unsteady : {"link", "left_s", "score"}) {
    lasting[unsteady] = json.at(unsteady).is_null();
  }
  const bool is_due = json != state_ && std::abs(time_s - state_s_) >= kStatePeriodS;
  if (lasting != lasting_state_ || is_due) {
    history_->add(json_message(MessageKind::kState, time_s, json));
    state_ = json;
    lasting_state_ = lasting;
    state_s_ = time_s;
  }
}

void RunPublisher::add_event(double time_s, const RunEvent& event) {
  history_->add(json_message(MessageKind::kEvent,
                             time_s,
                             {{"code", event.code},
                              {"level", name_of(event.level)},
                              {"text", event.text},
                              {"cause", event.cause},
                              {"remedy", event.remedy}}));
}

void RunPublisher::add_team(double time_s, const TeamState& team) {
  if (auto json = to_json(team); json != team_) {
    history_->add(json_message(MessageKind::kTeam, time_s, json));
    team_ = std::move(json);
  }
}

}  // namespace echomap::live_page
