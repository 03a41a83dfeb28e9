// SPDX-License-Identifier: MIT
#include "host/team_map/team_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
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

Eigen::Vector2d middle_m(const RobotMap& map) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const Pose2& T_map_submap : map.T_map_submaps()) {
    sum_m += T_map_submap.position_m();
  }
  return sum_m / static_cast<double>(map.T_map_submaps().size());
}

std::optional<std::size_t> find_in(const TeamComponent& component, const std::string& robot) {
  const auto found = std::ranges::lower_bound(component.robots, robot);
  return found == component.robots.end() || *found != robot
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - component.robots.begin()));
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

void TeamMap::set_known_pose(const KnownPose& known) {
  const RelativePose& relative = known.relative;
  if (known.robot < known.peer) {
    known_poses_[{known.robot, known.peer}] = relative;
  } else {
    known_poses_[{known.peer, known.robot}] = {
        relative.T_own_peer.inverse(), relative.position_stddev_m, relative.heading_stddev_rad};
  }
  changed_.push_back(known.robot);
}

void TeamMap::accept_join(const std::string& robot,
                          const std::string& peer,
                          const Pose2& T_robot_peer) {
  const Pair pair = std::minmax(robot, peer);
  MapJoin& join = joins_.try_emplace(pair, params_.joining).first->second;
  if (join.accept_join(pair.first == robot ? T_robot_peer : T_robot_peer.inverse())) {
    changed_.push_back(robot);
  }
}

bool TeamMap::update() {
  if (changed_.empty()) {
    return false;
  }
  join_pairs();
  std::vector<TeamComponent> begun = connected();
  std::vector<TeamComponent> components = begun;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto before = std::find_if(begun_.begin(), begun_.end(), [&](const auto& other) {
      return !has_news(begun[i]) && is_like(begun[i], other);
    });
    if (before != begun_.end()) {
      components[i] = components_[static_cast<std::size_t>(before - begun_.begin())];
    } else {
      align(components[i]);
    }
  }
  changed_.clear();
  const bool has_changed = !std::equal(
      components.begin(), components.end(), components_.begin(), components_.end(), is_like);
  begun_ = std::move(begun);
  components_ = std::move(components);
  merged_.clear();
  return has_changed;
}

bool TeamMap::has_news(const TeamComponent& component) const {
  return std::any_of(changed_.begin(), changed_.end(), [&](const std::string& robot) {
    return std::binary_search(component.robots.begin(), component.robots.end(), robot);
  });
}

void TeamMap::join_pairs() {
  for (auto one = robots_.begin(); one != robots_.end(); ++one) {
    for (auto other = std::next(one); other != robots_.end(); ++other) {
      const bool is_new = std::any_of(changed_.begin(), changed_.end(), [&](const auto& robot) {
        return robot == one->first || robot == other->first;
      });
      if (is_new && !known_poses_.contains({one->first, other->first}) &&
          !one->second.submaps().empty() && !other->second.submaps().empty()) {
        join_pair({one->first, other->first});
      }
    }
  }
  undo_contradicted();
  count_joins();
}

/// The relative pose of two maps that are joined through others is known; their own readings
/// confirm or contradict it.
void TeamMap::join_pair(const Pair& pair) {
  const RobotMap& one = robots_.at(pair.first);
  const RobotMap& other = robots_.at(pair.second);
  MapJoin& join = joins_.try_emplace(pair, params_.joining).first->second;
  const auto known = relative_pose(pair.first, pair.second);
  if (join.T_first_second() || !known) {
    join.update(one, other);
    return;
  }
  join.try_at(one, other, known->T_own_peer);
  if (join.is_contradicted()) {
    const std::vector<MapLink> all = links();
    if (const std::size_t weakest = weakest_between(pair.first, pair.second, all);
        weakest < all.size() && !known_poses_.contains({all[weakest].one, all[weakest].other})) {
      joins_.at({all[weakest].one, all[weakest].other}).undo();
    }
  }
}

void TeamMap::undo_contradicted() {
  const std::vector<MapLink> all = links();
  std::vector<std::string> robots;
  for (const auto& [robot, map] : robots_) {
    robots.push_back(robot);
  }
  for (const std::size_t i : join_tree(robots, all, params_.tree).contradicted) {
    if (const Pair pair{all[i].one, all[i].other}; !known_poses_.contains(pair)) {
      joins_.at(pair).undo();
    }
  }
}

void TeamMap::count_joins() {
  counts_ = {};
  for (const auto& [pair, join] : joins_) {
    counts_.joins += join.joins();
    counts_.undone += join.undone();
  }
}

std::vector<MapLink> TeamMap::links() const {
  std::vector<MapLink> links;
  const auto add = [&](const Pair& pair, const Pose2& T_one_other, double weight) {
    const auto one = robots_.find(pair.first);
    const auto other = robots_.find(pair.second);
    if (one != robots_.end() && other != robots_.end() && !one->second.submaps().empty() &&
        !other->second.submaps().empty()) {
      links.push_back({pair.first, pair.second, T_one_other, weight, middle_m(other->second)});
    }
  };
  for (const auto& [pair, relative] : known_poses_) {
    add(pair, relative.T_own_peer, std::numeric_limits<double>::infinity());
  }
  for (const auto& [pair, join] : joins_) {
    if (join.T_first_second() && !known_poses_.contains(pair)) {
      add(pair, *join.T_first_second(), join.weight());
    }
  }
  return links;
}

std::vector<TeamComponent> TeamMap::connected() const {
  std::vector<std::string> robots;
  for (const auto& [robot, map] : robots_) {
    if (!map.submaps().empty()) {
      robots.push_back(robot);
    }
  }
  std::vector<TeamComponent> components;
  for (const JoinedMaps& maps : join_tree(robots, links(), params_.tree).components) {
    TeamComponent& component = components.emplace_back();
    component.robots = maps.robots;
    for (std::size_t i = 0; i < maps.robots.size(); ++i) {
      auto& poses = component.T_team_submaps.emplace_back();
      for (const Pose2& T_map_submap : robots_.at(maps.robots[i]).T_map_submaps()) {
        poses.push_back(maps.T_first_maps[i] * T_map_submap);
      }
    }
  }
  return components;
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
  std::vector<TeamRelation> relations;
  for (const auto& [pair, relative] : known_poses_) {
    const auto robot = find_in(component, pair.first);
    const auto peer = find_in(component, pair.second);
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
  return relations;
}

const TeamComponent* TeamMap::component_of(const std::string& robot) const {
  for (const TeamComponent& component : components_) {
    if (find_in(component, robot)) {
      return &component;
    }
  }
  return nullptr;
}

std::optional<RelativePose> TeamMap::relative_pose(const std::string& own,
                                                   const std::string& peer) const {
  const TeamComponent* component = component_of(own);
  if (component == nullptr) {
    return std::nullopt;
  }
  const auto i = find_in(*component, own);
  const auto k = find_in(*component, peer);
  if (!i || !k) {
    return std::nullopt;
  }
  if (*i == *k) {
    return RelativePose{};
  }
  return RelativePose{
      component->T_team_maps[*i].inverse() * component->T_team_maps[*k],
      std::hypot(component->position_stddev_m[*i], component->position_stddev_m[*k]),
      std::hypot(component->heading_stddev_rad[*i], component->heading_stddev_rad[*k])};
}

const MergedMap& TeamMap::merged(const std::string& robot) {
  const TeamComponent& component = known_component_of(robot);
  if (const auto made = merged_.find(robot); made != merged_.end()) {
    return made->second;
  }
  const auto T_map_submaps = this->T_map_submaps(robot);
  std::vector<MapShare> shares;
  for (std::size_t i = 0; i < component.robots.size(); ++i) {
    const RobotMap& map = robots_.at(component.robots[i]);
    shares.push_back({map.robot(), map.body_radius_m(), placed(map.submaps(), T_map_submaps[i])});
  }
  mapping::SonarMapperParams params = params_.mapper;
  params.surfaces.beam_half_angle_rad = robots_.at(robot).beam_half_angle_rad();
  MergedMapper& mapper = mappers_.try_emplace(robot, params).first->second;
  return merged_.emplace(robot, mapper.merge(shares)).first->second;
}

std::vector<StopEnd> TeamMap::stop_ends(const std::string& robot) const {
  const std::size_t own = find_in(known_component_of(robot), robot).value();
  return team_map::stop_ends(robots_.at(robot).submaps(), T_map_submaps(robot)[own]);
}

const TeamComponent& TeamMap::known_component_of(const std::string& robot) const {
  const TeamComponent* component = component_of(robot);
  if (component == nullptr) {
    throw std::out_of_range("nothing is known of robot '" + robot + "'");
  }
  return *component;
}

std::vector<std::vector<Pose2>> TeamMap::T_map_submaps(const std::string& robot) const {
  const TeamComponent& component = known_component_of(robot);
  const Pose2 T_map_team = component.T_team_maps[find_in(component, robot).value()].inverse();
  std::vector<std::vector<Pose2>> T_map_submaps = component.T_team_submaps;
  for (std::vector<Pose2>& poses : T_map_submaps) {
    for (Pose2& pose : poses) {
      pose = T_map_team * pose;
    }
  }
  return T_map_submaps;
}

}  // namespace echomap::team_map
