// SPDX-License-Identifier: MIT
#include "host/team_map/team_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace echomap::team_map {

namespace {

using geometry::Pose2;

Pose2 rounded(const Pose2& pose) {
  constexpr double kPerM = 1e4;
  constexpr double kPerRad = 1e5;
  return {std::round(pose.x_m() * kPerM) / kPerM,
          std::round(pose.y_m() * kPerM) / kPerM,
          std::round(pose.heading_rad() * kPerRad) / kPerRad};
}

bool is_like(const TeamComponent& one, const TeamComponent& other) {
  const auto same = [](const Pose2& a, const Pose2& b) {
    return a.position_m() == b.position_m() && a.heading_rad() == b.heading_rad();
  };
  return one.robots == other.robots &&
         std::equal(one.T_team_submaps.begin(),
                    one.T_team_submaps.end(),
                    other.T_team_submaps.begin(),
                    other.T_team_submaps.end(),
                    [&](const auto& a, const auto& b) {
                      return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
                    });
}

std::size_t index_of(const TeamComponent& component, const std::string& robot) {
  return static_cast<std::size_t>(
      std::lower_bound(component.robots.begin(), component.robots.end(), robot) -
      component.robots.begin());
}

}  // namespace

TeamMap::TeamMap(const TeamMapParams& params) : params_(params) {
  validate(params.joining);
  validate(params.graph);
  mapping::SonarMapper check(params.mapper);
}

void TeamMap::take(const RobotRecord& record) {
  RobotMap& map = robots_.try_emplace(record.robot, params_.mapper).first->second;
  if (map.take(record)) {
    changed_.push_back(record.robot);
  }
}

void TeamMap::tell(const ToldPose& told) {
  const RelativePose& relative = told.relative;
  if (told.robot < told.peer) {
    told_[{told.robot, told.peer}] = relative;
  } else {
    told_[{told.peer, told.robot}] = {
        relative.T_own_peer.inverse(), relative.position_stddev_m, relative.heading_stddev_rad};
  }
  changed_.push_back(told.robot);
}

void TeamMap::see(const PeerSighting& sighting) {
  sightings_.push_back(sighting);
  changed_.push_back(sighting.robot);
}

bool TeamMap::update() {
  if (changed_.empty()) {
    return false;
  }
  join_pairs();
  changed_.clear();
  std::vector<TeamComponent> components = connected();
  for (TeamComponent& component : components) {
    begin(component);
    align(component);
  }
  const bool has_changed = !std::equal(
      components.begin(), components.end(), components_.begin(), components_.end(), is_like);
  components_ = std::move(components);
  merged_.clear();
  return has_changed;
}

void TeamMap::join_pairs() {
  counts_ = {};
  for (auto one = robots_.begin(); one != robots_.end(); ++one) {
    for (auto other = std::next(one); other != robots_.end(); ++other) {
      const Pair pair{one->first, other->first};
      MapJoin& join = joins_.try_emplace(pair, params_.joining).first->second;
      const bool is_new = std::any_of(changed_.begin(), changed_.end(), [&](const auto& robot) {
        return robot == one->first || robot == other->first;
      });
      if (is_new && !told_.contains(pair) && !one->second.submaps().empty() &&
          !other->second.submaps().empty()) {
        join.update(one->second, other->second);
      }
      counts_.joins += join.joins();
      counts_.undone += join.undone();
    }
  }
}

std::optional<Pose2> TeamMap::T_joined(const std::string& one, const std::string& other) const {
  if (one > other) {
    const auto T_other_one = T_joined(other, one);
    return T_other_one ? std::optional(T_other_one->inverse()) : std::nullopt;
  }
  if (const auto told = told_.find({one, other}); told != told_.end()) {
    return told->second.T_own_peer;
  }
  const auto join = joins_.find({one, other});
  return join == joins_.end() ? std::nullopt : join->second.T_first_second();
}

std::vector<TeamComponent> TeamMap::connected() const {
  std::vector<TeamComponent> components;
  std::vector<std::string> left;
  for (const auto& [robot, map] : robots_) {
    if (!map.submaps().empty()) {
      left.push_back(robot);
    }
  }
  while (!left.empty()) {
    TeamComponent component;
    component.robots = {left.front()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < component.robots.size(); ++i) {
      const auto reached =
          std::stable_partition(left.begin(), left.end(), [&](const std::string& other) {
            return !T_joined(component.robots[i], other);
          });
      component.robots.insert(component.robots.end(), reached, left.end());
      left.erase(reached, left.end());
    }
    std::sort(component.robots.begin(), component.robots.end());
    components.push_back(std::move(component));
  }
  return components;
}

void TeamMap::begin(TeamComponent& component) const {
  // Reached one after the other along joins, from the first robot on.
  std::map<std::string, Pose2> T_team_maps{{component.robots.front(), Pose2()}};
  while (T_team_maps.size() < component.robots.size()) {
    const auto known = T_team_maps;
    for (const auto& [robot, T_team_map] : known) {
      for (const std::string& other : component.robots) {
        const auto T_robot_other = T_joined(robot, other);
        if (T_robot_other && !T_team_maps.contains(other)) {
          T_team_maps[other] = T_team_map * *T_robot_other;
        }
      }
    }
  }
  for (const std::string& robot : component.robots) {
    auto& poses = component.T_team_submaps.emplace_back();
    for (const Pose2& T_map_submap : robots_.at(robot).T_map_submaps()) {
      poses.push_back(T_team_maps[robot] * T_map_submap);
    }
  }
}

void TeamMap::align(TeamComponent& component) const {
  std::vector<TeamTrack> tracks;
  for (std::size_t i = 0; i < component.robots.size(); ++i) {
    tracks.push_back({&robots_.at(component.robots[i]), component.T_team_submaps[i]});
  }
  if (tracks.size() > 1) {
    TeamGraphParams graph = params_.graph;
    graph.heading.beam_half_angle_rad = tracks.front().map->beam_half_angle_rad();
    align_team(graph, relations_in(component), tracks);
  }
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    std::vector<Pose2>& poses = component.T_team_submaps[i];
    poses.clear();
    for (const Pose2& pose : tracks[i].T_team_submaps) {
      poses.push_back(rounded(pose));
    }
    component.T_team_maps.push_back(poses.back() * tracks[i].map->T_map_submaps().back().inverse());
    component.position_stddev_m.push_back(tracks[i].position_stddev_m);
    component.heading_stddev_rad.push_back(tracks[i].heading_stddev_rad);
  }
}

std::vector<TeamRelation> TeamMap::relations_in(const TeamComponent& component) const {
  const auto index_of = [&](const std::string& robot) -> std::optional<std::size_t> {
    const auto found = std::find(component.robots.begin(), component.robots.end(), robot);
    return found == component.robots.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - component.robots.begin()));
  };
  std::vector<TeamRelation> relations;
  for (const auto& [pair, relative] : told_) {
    const auto robot = index_of(pair.first);
    const auto peer = index_of(pair.second);
    if (robot && peer) {
      const Pose2& T_robot_submap = robots_.at(pair.first).T_map_submaps().front();
      const Pose2& T_peer_submap = robots_.at(pair.second).T_map_submaps().front();
      relations.push_back({*robot,
                           0,
                           *peer,
                           0,
                           T_robot_submap.inverse() * relative.T_own_peer * T_peer_submap,
                           relative.position_stddev_m,
                           relative.heading_stddev_rad});
    }
  }
  for (const PeerSighting& seen : sightings_) {
    const auto robot = index_of(seen.robot);
    const auto peer = index_of(seen.peer);
    if (robot && peer && seen.submap < component.T_team_submaps[*robot].size() &&
        seen.peer_submap < component.T_team_submaps[*peer].size()) {
      relations.push_back({*robot,
                           seen.submap,
                           *peer,
                           seen.peer_submap,
                           seen.T_submap_peer,
                           seen.position_stddev_m,
                           seen.heading_stddev_rad});
    }
  }
  return relations;
}

const TeamComponent* TeamMap::component_of(const std::string& robot) const {
  for (const TeamComponent& component : components_) {
    if (std::binary_search(component.robots.begin(), component.robots.end(), robot)) {
      return &component;
    }
  }
  return nullptr;
}

std::optional<RelativePose> TeamMap::relative_pose(const std::string& own,
                                                   const std::string& peer) const {
  const TeamComponent* component = component_of(own);
  if (component == nullptr || component != component_of(peer)) {
    return std::nullopt;
  }
  const std::size_t i = index_of(*component, own);
  const std::size_t k = index_of(*component, peer);
  if (i == k) {
    return RelativePose{};
  }
  return RelativePose{
      component->T_team_maps[i].inverse() * component->T_team_maps[k],
      std::hypot(component->position_stddev_m[i], component->position_stddev_m[k]),
      std::hypot(component->heading_stddev_rad[i], component->heading_stddev_rad[k])};
}

const MergedMap& TeamMap::merged(const std::string& robot) {
  const TeamComponent* component = component_of(robot);
  if (component == nullptr) {
    throw std::out_of_range("nothing is known of robot '" + robot + "'");
  }
  if (const auto made = merged_.find(robot); made != merged_.end()) {
    return made->second;
  }
  const Pose2 T_map_team = component->T_team_maps[index_of(*component, robot)].inverse();
  std::vector<MapShare> shares;
  for (std::size_t i = 0; i < component->robots.size(); ++i) {
    const RobotMap& map = robots_.at(component->robots[i]);
    std::vector<Pose2> T_map_submaps;
    for (const Pose2& T_team_submap : component->T_team_submaps[i]) {
      T_map_submaps.push_back(T_map_team * T_team_submap);
    }
    shares.push_back({map.robot(), map.body_radius_m(), placed(map.submaps(), T_map_submaps)});
  }
  mapping::SonarMapperParams params = params_.mapper;
  params.surfaces.beam_half_angle_rad = robots_.at(robot).beam_half_angle_rad();
  MergedMapper& mapper = mappers_.try_emplace(robot, params).first->second;
  return merged_.emplace(robot, mapper.merge(shares)).first->second;
}

}  // namespace echomap::team_map
