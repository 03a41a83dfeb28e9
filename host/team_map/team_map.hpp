// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/team_map/join_tree.hpp"
#include "host/team_map/map_join.hpp"
#include "host/team_map/merged_map.hpp"
#include "host/team_map/placed_submaps.hpp"
#include "host/team_map/robot_map.hpp"
#include "host/team_map/submap.hpp"
#include "host/team_map/team_graph.hpp"

namespace echomap::team_map {

/// How a team's maps are joined, aligned and rendered.
struct TeamMapParams {
  MapJoinParams joining;
  JoinTreeParams tree;
  TeamGraphParams graph;
  /// Mapper of the merged map and of each robot's own; the beam is each robot's.
  mapping::SonarMapperParams mapper;
};

/// Pose of a robot's map in another one's, with its standard deviations.
struct RelativePose {
  geometry::Pose2 T_own_peer;
  double position_stddev_m = 0.0;
  double heading_stddev_rad = 0.0;
};

/// Pose of the map of `peer` in that of `robot` that is known from outside, for example because
/// both starts are known.
struct KnownPose {
  std::string robot;
  std::string peer;
  RelativePose relative;
};

/// Robots whose maps are joined, in the frame of the first one's map, as its first submap has it.
struct TeamComponent {
  std::vector<std::string> robots;  ///< By name.
  /// Poses of each robot's submaps after alignment, rounded to 0.1 mm and 10 urad: two hosts with
  /// the same data have the same numbers.
  std::vector<std::vector<geometry::Pose2>> T_team_submaps;
  /// Transforms from each robot's own map to the team's frame, at the robot's last stop.
  std::vector<geometry::Pose2> T_team_maps;
  /// Standard deviations of those, against the first robot.
  std::vector<double> position_stddev_m;
  std::vector<double> heading_stddev_rad;
};

/// Counts of joins so far.
struct JoinCounts {
  std::size_t joins = 0;
  std::size_t undone = 0;  ///< Joins that later data have contradicted.
};

/// The maps of a team whose robots do not know where the others started: finds their relative
/// poses, joins them where those are sure, and undoes a join that is contradicted later
/// (docs/algorithms/team_map.md). A function of its input, in the order in which it came.
class TeamMap {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit TeamMap(const TeamMapParams& params = {});

  /// Takes all that a robot has published so far, in place of what it had published before.
  void take(const RobotRecord& record);
  /// Sets a relative pose that holds from now on, whatever the readings show.
  void set_known_pose(const KnownPose& known);

  /// Adopts a join that other robots have made, until the data here contradict it.
  void accept_join(const std::string& robot,
                   const std::string& peer,
                   const geometry::Pose2& T_robot_peer);

  /// Searches for joins, checks those that there are, and aligns what is joined; to be called after
  /// new input. Returns whether the components or their poses have changed.
  bool update();

  /// Components of all robots that have a submap, single robots included, in the order of their
  /// first robots' names.
  const std::vector<TeamComponent>& components() const { return components_; }
  /// The component of a robot; null where nothing is known of it.
  const TeamComponent* component_of(const std::string& robot) const;
  /// Transform from the map of `peer` to that of `own`, at the last stops of both; empty while they
  /// are not joined.
  std::optional<RelativePose> relative_pose(const std::string& own, const std::string& peer) const;
  /// The map of a robot's component, in the frame of that robot's map at its last stop; built on
  /// demand. Throws std::out_of_range for a robot of which nothing is known.
  const MergedMap& merged(const std::string& robot);
  /// Poses of that robot at the ends of its stops, on that map. Throws std::out_of_range as
  /// `merged`.
  std::vector<StopEnd> stop_ends(const std::string& robot) const;

  const JoinCounts& counts() const { return counts_; }

 private:
  using Pair = std::pair<std::string, std::string>;

  void join_pairs();
  void join_pair(const Pair& pair);
  void undo_contradicted();
  void count_joins();
  /// All links that hold now. Known poses are among them and outweigh all others.
  std::vector<MapLink> links() const;
  std::vector<TeamComponent> connected() const;
  const TeamComponent& known_component_of(const std::string& robot) const;
  /// Poses of the submaps of each robot of its component, on that robot's map.
  std::vector<std::vector<geometry::Pose2>> T_map_submaps(const std::string& robot) const;
  void align(TeamComponent& component) const;
  bool has_news(const TeamComponent& component) const;
  std::vector<TeamRelation> relations_in(const TeamComponent& component) const;
  TeamMapParams params_;
  std::map<std::string, RobotMap> robots_;
  std::map<Pair, MapJoin> joins_;
  std::map<Pair, RelativePose> known_poses_;
  std::vector<std::string> changed_;
  std::vector<TeamComponent> begun_;  ///< The components as they were before they were aligned.
  std::vector<TeamComponent> components_;
  std::map<std::string, MergedMapper> mappers_;  ///< By the robot whose frame it is.
  std::map<std::string, MergedMap> merged_;
  JoinCounts counts_;
};

}  // namespace echomap::team_map
