// SPDX-License-Identifier: MIT
#include "host/fleet_member/team_picture.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace echomap::fleet_member {
namespace {

using fleet::Attendance;
using fleet::FleetMap;
using fleet::FleetRobot;
using fleet::FleetState;
using team_exploration::Claim;
using team_exploration::Peer;
using team_exploration::TeamView;

/// A robot whose position is less certain than this is left out: to keep off by so much would close
/// the floor, and to drop all echoes from there would blind the sonar.
constexpr double kMaxPeerStddevM = 1.0;

/// Standard deviation of the position in the direction in which it is the largest.
double position_stddev_m(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance.topLeftCorner<2, 2>(),
                                                              Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

/// A robot that has left stays at its last pose; the pose of one that fell silent is unknown.
std::optional<Peer> peer_of(const FleetRobot& robot, const team_map::RelativePose& relative) {
  if (robot.attendance == Attendance::kGone || !robot.pose ||
      robot.pose->map_number != robot.map_number) {
    return std::nullopt;
  }
  Peer peer;
  peer.robot = robot.name;
  peer.T_map_robot = relative.T_own_peer * robot.pose->estimate.T_map_robot;
  peer.position_stddev_m =
      std::hypot(relative.position_stddev_m, position_stddev_m(robot.pose->estimate.covariance));
  if (!(peer.position_stddev_m <= kMaxPeerStddevM)) {
    return std::nullopt;
  }
  peer.radius_m = robot.traits.body_radius_m;
  peer.stays = robot.attendance == Attendance::kLeft;
  if (!peer.stays) {
    peer.age_s = robot.pose->age_s;
    peer.speed_m_per_s = robot.pose->speed_m_per_s;
  }
  return peer;
}

std::vector<Claim> claims_of(const FleetRobot& robot, const geometry::Pose2& T_own_peer) {
  std::vector<Claim> claims;
  if (robot.claims_map_number == robot.map_number) {
    claims = robot.claims;
  }
  for (Claim& claim : claims) {
    claim.robot = robot.name;
    claim.at_m = T_own_peer * claim.at_m;
  }
  return claims;
}

}  // namespace

std::string map_name(const std::string& robot, std::uint16_t number) {
  return robot + "." + std::to_string(number);
}

bool TeamPicture::take(const FleetState& state) {
  if (revision_ == state.revision) {
    return false;
  }
  revision_ = state.revision;
  for (const FleetRobot& robot : state.robots) {
    for (const FleetMap& map : robot.maps) {
      if (!map.record->submaps.empty()) {
        team_map::RobotRecord record = *map.record;
        record.robot = map_name(robot.name, map.number);
        team_.take(record);
      }
    }
  }
  return team_.update();
}

bool TeamPicture::take_with_joins(const FleetState& state) {
  if (revision_ != state.revision) {
    for (const FleetRobot& robot : state.robots) {
      for (const fleet_messages::AlignedMap& map : robot.alignment) {
        const fleet_messages::AlignedMap& first = robot.alignment.front();
        if (&map != &first) {
          team_.accept_join(map_name(first.robot, first.map_number),
                            map_name(map.robot, map.map_number),
                            first.T_component_map.inverse() * map.T_component_map);
        }
      }
    }
  }
  return take(state);
}

void TeamPicture::set_known_pose(const std::string& own_map,
                                 const std::string& peer_map,
                                 const team_map::RelativePose& relative) {
  team_.set_known_pose({own_map, peer_map, relative});
}

std::optional<team_map::RelativePose> TeamPicture::relative_pose(const std::string& own_map,
                                                                 const FleetRobot& robot) const {
  return team_.relative_pose(own_map, map_name(robot.name, robot.map_number));
}

std::vector<fleet_messages::AlignedMap> TeamPicture::alignment(const std::string& robot,
                                                               std::uint16_t map_number) const {
  const std::string own_map = map_name(robot, map_number);
  const team_map::TeamComponent* component = team_.component_of(own_map);
  std::vector<fleet_messages::AlignedMap> maps;
  if (component == nullptr || component->robots.size() < 2 ||
      component->robots.front() != own_map) {
    return maps;
  }
  for (std::size_t i = 0; i < component->robots.size(); ++i) {
    const std::string& name = component->robots[i];
    const std::size_t dot = name.rfind('.');
    maps.push_back({name.substr(0, dot),
                    static_cast<std::uint16_t>(std::stoul(name.substr(dot + 1))),
                    component->T_team_maps[i],
                    component->T_team_submaps[i]});
  }
  return maps;
}

TeamView TeamPicture::view(const FleetState& state,
                           const std::string& robot,
                           std::uint16_t map_number) {
  const std::string own_map = map_name(robot, map_number);
  const team_map::TeamComponent* component = team_.component_of(own_map);
  TeamView view;
  if (component == nullptr || component->robots.size() < 2) {
    return view;
  }
  const team_map::MergedMap& merged = team_.merged(own_map);
  view.grid = merged.grid;
  view.scans = merged.scans;
  view.features = merged.features;
  view.been_m = merged.been_m;
  view.peers = peers(state, robot, map_number);
  for (const FleetRobot& other : state.robots) {
    const auto relative = relative_pose(own_map, other);
    if (other.name == robot || !relative) {
      continue;
    }
    const std::vector<Claim> claims = claims_of(other, relative->T_own_peer);
    view.claims.insert(view.claims.end(), claims.begin(), claims.end());
  }
  return view;
}

std::vector<Peer> TeamPicture::peers(const FleetState& state,
                                     const std::string& robot,
                                     std::uint16_t map_number) const {
  std::vector<Peer> peers;
  for (const FleetRobot& other : state.robots) {
    const auto relative = relative_pose(map_name(robot, map_number), other);
    const auto peer = other.name != robot && relative ? peer_of(other, *relative) : std::nullopt;
    if (peer) {
      peers.push_back(*peer);
    }
  }
  return peers;
}

}  // namespace echomap::fleet_member
