// SPDX-License-Identifier: MIT
#include "host/fleet/robot_knowledge.hpp"

#include <algorithm>
#include <limits>
#include <variant>

#include "host/fleet_messages/payload.hpp"

namespace echomap::fleet {
namespace {

/// Longest time between poses of a robot that drives, whatever the broker delays.
constexpr double kDrivesS = 3.0;

double forward_m_per_s(const FleetPose& before, const FleetPose& now) {
  const double step_s = now.stamp_s - before.stamp_s;
  if (before.map_number != now.map_number || step_s <= 0.0 || step_s > kDrivesS) {
    return 0.0;
  }
  const geometry::Pose2& T_map_before = before.estimate.T_map_robot;
  return (T_map_before.inverse() * now.estimate.T_map_robot.position_m()).x() / step_s;
}

}  // namespace

using fleet_messages::ContentHash;
using fleet_messages::PresenceState;

bool RobotKnowledge::take(const fleet_messages::MessageBody& body,
                          const ContentHash& hash,
                          double now_s) {
  using namespace fleet_messages;
  objects_ += is_object(kind_of(body)) ? 1 : 0;
  if (const auto* submap = std::get_if<SubmapMessage>(&body)) {
    return add(*submap, hash);
  }
  if (const auto* source = std::get_if<SourceMessage>(&body)) {
    return add(*source, hash);
  }
  if (const auto* graph = std::get_if<GraphMessage>(&body)) {
    return set_graph(*graph);
  }
  if (const auto* alignment = std::get_if<AlignmentMessage>(&body)) {
    return set_alignment(*alignment);
  }
  if (const auto* presence = std::get_if<PresenceMessage>(&body)) {
    return set_presence(*presence);
  }
  if (const auto* pose = std::get_if<PoseMessage>(&body)) {
    set_pose(*pose, now_s);
  } else if (const auto* claims = std::get_if<ClaimMessage>(&body)) {
    set_claims(*claims);
  } else if (const auto* search = std::get_if<SearchMessage>(&body)) {
    set_search(*search);
  } else if (const auto* manifest = std::get_if<ManifestMessage>(&body)) {
    pages_[manifest->page] = manifest->objects;
  }
  return false;
}

bool RobotKnowledge::has_room_for(const fleet_messages::MessageBody& body) const {
  using namespace fleet_messages;
  if (const auto* manifest = std::get_if<ManifestMessage>(&body)) {
    return manifest->page < kMaxObjectsOfARobot / ManifestMessage::kObjectsPerPage;
  }
  const auto map_number = map_number_of(body);
  const bool makes_map =
      map_number && (is_object(kind_of(body)) || kind_of(body) == TopicKind::kGraph);
  if (makes_map && !maps_.contains(*map_number) && maps_.size() >= kMaxMapsOfARobot) {
    return false;
  }
  return !is_object(kind_of(body)) || objects_ < kMaxObjectsOfARobot;
}

Attendance RobotKnowledge::attendance(double now_s, double gone_after_s) const {
  if (presence_ && presence_->state == static_cast<std::uint8_t>(PresenceState::kLeft)) {
    return Attendance::kLeft;
  }
  return is_lost_ || age_s(now_s) > gone_after_s ? Attendance::kGone : Attendance::kAlive;
}

double RobotKnowledge::age_s(double now_s) const {
  return last_seen_s_ ? now_s - *last_seen_s_ : std::numeric_limits<double>::infinity();
}

std::vector<ContentHash> RobotKnowledge::promised() const {
  std::vector<ContentHash> all;
  for (const auto& [page, objects] : pages_) {
    all.insert(all.end(), objects.begin(), objects.end());
  }
  return all;
}

bool RobotKnowledge::has_promised(const ContentHash& hash) const {
  return std::any_of(pages_.begin(), pages_.end(), [&](const auto& page) {
    return std::find(page.second.begin(), page.second.end(), hash) != page.second.end();
  });
}

FleetRobot RobotKnowledge::state(double now_s, double gone_after_s) const {
  FleetRobot robot;
  robot.name = name_;
  robot.attendance = attendance(now_s, gone_after_s);
  robot.age_s = age_s(now_s);
  robot.has_reported = has_reported_;
  if (presence_) {
    robot.traits = fleet_messages::to_traits(*presence_);
    robot.map_number = presence_->map_number;
    robot.known_objects = presence_->known_objects;
    robot.known_set = presence_->known_set;
  }
  for (const auto& [number, map] : maps_) {
    robot.maps.push_back(shown(number, map));
  }
  robot.pose = pose_;
  if (robot.pose) {
    robot.pose->age_s = now_s - posed_s_;
    if (robot.pose->age_s > kDrivesS) {
      robot.pose->speed_m_per_s = 0.0;
    }
  }
  if (robot.attendance == Attendance::kAlive) {
    robot.claims = claims_;
  }
  robot.claims_map_number = claims_map_number_;
  robot.search = search_;
  if (robot.search && robot.attendance != Attendance::kAlive) {
    robot.search->plan.clear();
  }
  robot.search_map_number = search_map_number_;
  robot.alignment = alignment_;
  return robot;
}

bool RobotKnowledge::add(const fleet_messages::SubmapMessage& message, const ContentHash& hash) {
  Map& map = maps_[message.map_number];
  const auto known = map.submaps.find(message.index);
  // Where two have the same index, all robots use the same one.
  if (known != map.submaps.end() && known->second.first <= hash) {
    return false;
  }
  map.submaps[message.index] = {hash, fleet_messages::to_submap(message)};
  map.record.reset();
  return true;
}

bool RobotKnowledge::add(const fleet_messages::SourceMessage& message, const ContentHash& hash) {
  Map& map = maps_[message.map_number];
  map.shown_batches.reset();
  return map.batches.emplace(hash, fleet_messages::to_source_batch(message)).second;
}

bool RobotKnowledge::set_graph(const fleet_messages::GraphMessage& message) {
  Map& map = maps_[message.map_number];
  if (map.graph == message) {
    return false;
  }
  map.graph = message;
  map.record.reset();
  return true;
}

bool RobotKnowledge::set_alignment(const fleet_messages::AlignmentMessage& message) {
  alignment_ = fleet_messages::to_aligned_maps(message);
  return true;
}

bool RobotKnowledge::set_presence(const fleet_messages::PresenceMessage& message) {
  const bool has_other_traits = !presence_ || presence_->body_radius_mm != message.body_radius_mm ||
                                presence_->beam_half_angle != message.beam_half_angle;
  presence_ = message;
  for (auto& [number, map] : maps_) {
    if (has_other_traits) {
      map.record.reset();
    }
  }
  return has_other_traits;
}

void RobotKnowledge::set_pose(const fleet_messages::PoseMessage& message, double now_s) {
  FleetPose pose{fleet_messages::to_pose_estimate(message),
                 message.map_number,
                 static_cast<double>(message.stamp_ms) / 1000.0};
  if (pose_) {
    pose.speed_m_per_s = forward_m_per_s(*pose_, pose);
  }
  pose_ = pose;
  posed_s_ = now_s;
}

void RobotKnowledge::set_claims(const fleet_messages::ClaimMessage& message) {
  claims_ = fleet_messages::to_claims(message, name_);
  claims_map_number_ = message.map_number;
}

void RobotKnowledge::set_search(const fleet_messages::SearchMessage& message) {
  search_ = fleet_messages::to_search_report(message);
  search_map_number_ = message.map_number;
}

FleetMap RobotKnowledge::shown(std::uint16_t number, const Map& map) const {
  if (map.record == nullptr) {
    auto record = std::make_shared<team_map::RobotRecord>();
    record->robot = name_;
    record->T_map_submaps = fleet_messages::to_poses(map.graph.T_map_submaps);
    for (const auto& [index, submap] : map.submaps) {
      if (index != record->submaps.size() || index >= record->T_map_submaps.size()) {
        break;
      }
      record->submaps.push_back(submap.second);
    }
    record->T_map_submaps.resize(record->submaps.size());
    if (presence_) {
      const auto traits = fleet_messages::to_traits(*presence_);
      record->beam_half_angle_rad = traits.beam_half_angle_rad;
      record->body_radius_m = traits.body_radius_m;
    }
    map.record = std::move(record);
  }
  if (map.shown_batches == nullptr) {
    auto batches = std::make_shared<std::vector<fleet_messages::SourceBatch>>();
    for (const auto& [hash, batch] : map.batches) {
      batches->push_back(batch);
    }
    std::stable_sort(batches->begin(), batches->end(), [](const auto& one, const auto& other) {
      return one.submap_index < other.submap_index;
    });
    map.shown_batches = std::move(batches);
  }
  return {number,
          map.record,
          fleet_messages::to_covariance(map.graph.latest_covariance),
          map.shown_batches};
}

}  // namespace echomap::fleet
