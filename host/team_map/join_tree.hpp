// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::team_map {

/// A join of two maps.
struct MapLink {
  std::string one;
  std::string other;
  geometry::Pose2 T_one_other;
  /// Weight of its evidence, to compare links (MapEvidence::weight).
  double weight = 0.0;
  /// The middle of the other map, in its own frame: links are compared there.
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
};

/// Maps that are joined, directly or through others.
struct JoinedMaps {
  std::vector<std::string> robots;            ///< By name.
  std::vector<geometry::Pose2> T_first_maps;  ///< Pose of each map in the first one.
};

/// Placement of all maps by their links.
struct JoinTree {
  std::vector<JoinedMaps> components;  ///< In the order of their first robots' names.
  /// Indices of the links that a cycle of stronger ones contradicts.
  std::vector<std::size_t> contradicted;
};

/// How far the two paths around a cycle of links may differ, since maps on both are distorted.
struct JoinTreeParams {
  double cycle_m = 0.8;
  double cycle_rad = 0.26;
};

/// Joins maps by the strongest links (maximum spanning tree; Kruskal 1956). A link that closes a
/// cycle is its weakest, and has to agree with the path around it: a cycle that does not close has
/// a wrong link in it (pairwise consistency, Mangelson et al. 2018).
JoinTree join_tree(const std::vector<std::string>& robots,
                   const std::vector<MapLink>& links,
                   const JoinTreeParams& params);

/// Index of the weakest link on the path from one robot to another; `links` are those that are not
/// contradicted. The number of links where there is no path.
std::size_t weakest_between(const std::string& one,
                            const std::string& other,
                            const std::vector<MapLink>& links);

}  // namespace echomap::team_map
