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

/// How a team's maps are joined, aligned and drawn.
struct TeamMapParams {
  MapJoinParams joining;
  JoinTreeParams tree;
  TeamGraphParams graph;
  /// Of the merged map, and of each robot's own; the beam is each robot's.
  mapping::SonarMapperParams mapper;
};

/// Where a robot's map lies in another one's, and how well that is known.
struct RelativePose {
  geometry::Pose2 T_own_peer;
  double position_stddev_m = 0.0;
  double heading_stddev_rad = 0.0;
};

/// That somebody who knows tells where the map of `peer` lies in that of `robot`: where both
/// started, say.
struct ToldPose {
  std::string robot;
  std::string peer;
  RelativePose relative;
};

/// Robots whose maps are joined, in the frame of the first one's map, as its first submap has it.
struct TeamComponent {
  std::vector<std::string> robots;  ///< By name.
  /// Of each robot, where its submaps are as all together have it. Rounded to 0.1 mm and 10 urad:
  /// two hosts that know the same have the same numbers.
  std::vector<std::vector<geometry::Pose2>> T_team_submaps;
  /// Of each robot: leads from its own map to the team's frame where it stood last.
  std::vector<geometry::Pose2> T_team_maps;
  /// How well that is known, against the first robot.
  std::vector<double> position_stddev_m;
  std::vector<double> heading_stddev_rad;
};

/// What joining has come to so far.
struct JoinCounts {
  std::size_t joins = 0;
  std::size_t undone = 0;  ///< Joins that what came later has contradicted.
};

/// The maps of a team whose robots do not know where the others started: finds how they lie to each
/// other, joins those where that is sure, and undoes a join that is contradicted later
/// (docs/algorithms/team_map.md). A function of what it was told, in that order.
class TeamMap {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit TeamMap(const TeamMapParams& params = {});

  /// Takes all that a robot has told so far, in place of what it had told before.
  void take(const RobotRecord& record);
  /// From now on this holds, whatever walls say.
  void tell(const ToldPose& told);

  /// Robots of the team have joined two maps: so they are here, too, until what is known
  /// contradicts that.
  void believe(const std::string& robot,
               const std::string& peer,
               const geometry::Pose2& T_robot_peer);

  /// To be called after something was taken: looks for joins, checks those that there are, and
  /// aligns what is joined. Answers whether the components or their poses have changed.
  bool update();

  /// All robots that have a submap, the alone ones too; in the order of their first robots' names.
  const std::vector<TeamComponent>& components() const { return components_; }
  /// The component of a robot; null where nothing is known of it.
  const TeamComponent* component_of(const std::string& robot) const;
  /// From the map of `peer` to that of `own`, where both stood last; empty while they are not
  /// joined.
  std::optional<RelativePose> relative_pose(const std::string& own, const std::string& peer) const;
  /// The map of a robot's component, in the frame of that robot's map where it stood last; made
  /// when it is asked for. Throws std::out_of_range for a robot of which nothing is known.
  const MergedMap& merged(const std::string& robot);
  /// Where that robot was when its stops ended, on that map. Throws std::out_of_range as `merged`.
  std::vector<StopEnd> stop_ends(const std::string& robot) const;

  const JoinCounts& counts() const { return counts_; }

 private:
  using Pair = std::pair<std::string, std::string>;

  void join_pairs();
  void join_pair(const Pair& pair);
  void undo_contradicted();
  void count_joins();
  /// All that holds now, told poses among them; they outweigh all others.
  std::vector<MapLink> links() const;
  std::vector<TeamComponent> connected() const;
  const TeamComponent& known_component_of(const std::string& robot) const;
  /// Of each robot of its component, where its submaps are on that robot's map.
  std::vector<std::vector<geometry::Pose2>> T_map_submaps(const std::string& robot) const;
  void align(TeamComponent& component) const;
  bool has_news(const TeamComponent& component) const;
  std::vector<TeamRelation> relations_in(const TeamComponent& component) const;
  TeamMapParams params_;
  std::map<std::string, RobotMap> robots_;
  std::map<Pair, MapJoin> joins_;
  std::map<Pair, RelativePose> told_;
  std::vector<std::string> changed_;
  std::vector<TeamComponent> begun_;  ///< The components as they were before they were aligned.
  std::vector<TeamComponent> components_;
  std::map<std::string, MergedMapper> mappers_;  ///< By the robot whose frame it is.
  std::map<std::string, MergedMap> merged_;
  JoinCounts counts_;
};

}  // namespace echomap::team_map
