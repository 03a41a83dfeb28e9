// SPDX-License-Identifier: MIT
#include "host/team_map/join_tree.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "host/geometry/angle.hpp"

namespace echomap::team_map {

namespace {

using geometry::Pose2;

/// The strongest first; of equal ones, the first.
std::vector<std::size_t> by_weight(const std::vector<MapLink>& links) {
  std::vector<std::size_t> order(links.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return links[a].weight > links[b].weight;
  });
  return order;
}

/// Maps that grow together; each begins in a group of its own.
class MapGroups {
 public:
  explicit MapGroups(const std::vector<std::string>& robots) {
    for (const std::string& robot : robots) {
      groups_[robot] = {robot, Pose2()};
    }
  }

  bool are_one(const MapLink& link) const {
    return groups_.at(link.one).first == groups_.at(link.other).first;
  }
  Pose2 T_one_other(const MapLink& link) const {
    return groups_.at(link.one).second.inverse() * groups_.at(link.other).second;
  }
  void unite(const MapLink& link) {
    const auto [group, T_group_one] = groups_.at(link.one);
    const auto [left, T_left_other] = groups_.at(link.other);
    const Pose2 T_group_left = T_group_one * link.T_one_other * T_left_other.inverse();
    for (auto& [robot, place] : groups_) {
      if (place.first == left) {
        place = {group, T_group_left * place.second};
      }
    }
  }

  std::vector<JoinedMaps> components() const {
    std::vector<JoinedMaps> components;
    std::map<std::string, std::size_t> indices;
    for (const auto& [robot, place] : groups_) {
      const auto [at, is_new] = indices.try_emplace(place.first, components.size());
      if (is_new) {
        components.emplace_back();
      }
      JoinedMaps& maps = components[at->second];
      maps.robots.push_back(robot);
      maps.T_first_maps.push_back(place.second);
    }
    for (JoinedMaps& maps : components) {
      const Pose2 T_first_group = maps.T_first_maps.front().inverse();
      for (Pose2& T_map : maps.T_first_maps) {
        T_map = T_first_group * T_map;
      }
      maps.T_first_maps.front() = Pose2();
    }
    return components;
  }

 private:
  /// Of each robot the name of its group, and where its map lies in that.
  std::map<std::string, std::pair<std::string, Pose2>> groups_;
};

}  // namespace

JoinTree join_tree(const std::vector<std::string>& robots,
                   const std::vector<MapLink>& links,
                   const JoinTreeParams& params) {
  MapGroups groups(robots);
  JoinTree tree;
  for (const std::size_t i : by_weight(links)) {
    const MapLink& link = links[i];
    if (!groups.are_one(link)) {
      groups.unite(link);
      continue;
    }
    const Pose2 around = groups.T_one_other(link);
    const double off_m = (around * link.middle_m - link.T_one_other * link.middle_m).norm();
    const double off_rad =
        std::abs(geometry::angle_between(around.heading_rad(), link.T_one_other.heading_rad()));
    if (off_m > params.cycle_m || off_rad > params.cycle_rad) {
      tree.contradicted.push_back(i);
    }
  }
  tree.components = groups.components();
  return tree;
}

std::size_t weakest_between(const std::string& one,
                            const std::string& other,
                            const std::vector<MapLink>& links) {
  // The strongest link that, with all stronger ones, leads from one to the other.
  std::vector<std::string> robots{one, other};
  for (const MapLink& link : links) {
    robots.push_back(link.one);
    robots.push_back(link.other);
  }
  MapGroups groups(robots);
  MapLink ends;
  ends.one = one;
  ends.other = other;
  for (const std::size_t i : by_weight(links)) {
    groups.unite(links[i]);
    if (groups.are_one(ends)) {
      return i;
    }
  }
  return links.size();
}

}  // namespace echomap::team_map
