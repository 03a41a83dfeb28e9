// SPDX-License-Identifier: MIT
#include "host/team_map/team_graph.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::team_map {

namespace {

using geometry::Pose2;
using mapping::ScanSurfaces;

/// A stand of the graph.
struct TeamStand {
  std::size_t robot = 0;
  std::size_t stop = 0;  ///< Counted through all robots.
  std::size_t submap = 0;
  slam::StopStand readings;
};

const slam::OdometryMark& mark_of(const std::vector<TeamTrack>& tracks, const TeamStand& stand) {
  return tracks[stand.robot].map->submaps()[stand.submap].readings[stand.readings.first].mark;
}

/// The readings of a submap's stands in the team's frame.
mapping::Scan readings_of(const std::vector<slam::StopReading>& readings,
                          std::size_t first,
                          std::size_t count,
                          const Pose2& T_team_stand) {
  const Pose2 T_team_odom = T_team_stand * readings[first].mark.T_odom_robot.inverse();
  mapping::Scan scan;
  for (std::size_t i = first; i < first + count; ++i) {
    const Pose2 T_team_robot = T_team_odom * readings[i].mark.T_odom_robot;
    scan.push_back({T_team_robot, T_team_robot * readings[i].T_robot_sonar, readings[i].range_m});
  }
  return scan;
}

/// The stops of all robots, one after the other.
class TeamStops {
 public:
  TeamStops(const TeamGraphParams& params, std::vector<TeamTrack>& tracks)
      : params_(params), tracks_(tracks) {
    for (std::size_t robot = 0; robot < tracks.size(); ++robot) {
      first_stops_.push_back(first_stands_.size());
      for (std::size_t submap = 0; submap < tracks[robot].T_team_submaps.size(); ++submap) {
        add_stop(robot, submap);
      }
    }
  }

  /// Moves all stands once.
  void align(const mapping::MatchedSurfaces& matched,
             const std::vector<TeamRelation>& relations,
             const slam::StopGraphParams& params) {
    slam::StopGraph graph = graph_over(matched, relations);
    slam::align_stops(params, graph);
    for (std::size_t i = 0; i < stands_.size(); ++i) {
      T_team_stands_[i] = graph.stands[i].T_map_robot;
    }
    calibrations_ = graph.calibrations;
    last_ = std::move(graph);
  }

  mapping::MatchedSurfaces match(double tolerance_factor) {
    mapping::SurfaceMatchingParams matching = params_.matching;
    matching.wall_bearing_tolerance_rad *= tolerance_factor;
    matching.post_bearing_tolerance_rad *= tolerance_factor;
    std::vector<ScanSurfaces> placed;
    for (const std::size_t first : first_stands_) {
      placed.push_back(mapping::moved(surfaces_of(stands_[first]), T_team_stands_[first]));
    }
    return mapping::match_surfaces(placed, matching);
  }

  void take_home() {
    for (const std::size_t first : first_stands_) {
      const TeamStand& stand = stands_[first];
      tracks_[stand.robot].T_team_submaps[stand.submap] = T_team_stands_[first];
    }
    widen_headings();
    for (std::size_t robot = 0; robot < tracks_.size(); ++robot) {
      set_stddevs(robot);
    }
  }

 private:
  /// To what they are known by readings that share errors; where stops lie depends little on it.
  void widen_headings() {
    for (slam::GraphStand& stand : last_.stands) {
      if (stand.heading) {
        stand.heading->stddev_rad /= std::sqrt(params_.reading_weight);
      }
    }
  }

  void set_stddevs(std::size_t robot) {
    const std::size_t end =
        robot + 1 < first_stops_.size() ? first_stops_[robot + 1] : first_stands_.size();
    const auto covariance = slam::covariance_of(params_.graph, last_, first_stands_[end - 1]);
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    TeamTrack& track = tracks_[robot];
    track.position_stddev_m =
        covariance ? std::sqrt(covariance->topLeftCorner<2, 2>().trace()) : kUnknown;
    track.heading_stddev_rad = covariance ? std::sqrt((*covariance)(2, 2)) : kUnknown;
  }

  void add_stop(std::size_t robot, std::size_t submap) {
    const auto& readings = tracks_[robot].map->submaps()[submap].readings;
    const std::size_t stop = first_stands_.size();
    first_stands_.push_back(stands_.size());
    const Pose2 T_team_odom =
        tracks_[robot].T_team_submaps[submap] * readings.front().mark.T_odom_robot.inverse();
    for (const slam::StopStand& stand : slam::stands_in(readings, stop, params_.stands)) {
      stands_.push_back({robot, stop, submap, stand});
      T_team_stands_.push_back(T_team_odom * readings[stand.first].mark.T_odom_robot);
    }
  }

  const ScanSurfaces& surfaces_of(const TeamStand& stand) const {
    return tracks_[stand.robot].map->surfaces()[stand.submap];
  }

  slam::StopGraph graph_over(const mapping::MatchedSurfaces& matched,
                             const std::vector<TeamRelation>& relations) const {
    const slam::SonarScene scene(matched, params_.heading);
    slam::StopGraph graph;
    graph.calibrations = calibrations_;
    graph.calibrations.resize(tracks_.size());
    for (std::size_t i = 0; i < stands_.size(); ++i) {
      slam::GraphStand& stand = graph.stands.emplace_back();
      stand.T_map_robot = T_team_stands_[i];
      stand.robot = stands_[i].robot;
      if (i > 0 && stands_[i - 1].robot == stands_[i].robot) {
        stand.piece_before =
            slam::piece_between(mark_of(tracks_, stands_[i - 1]), mark_of(tracks_, stands_[i]));
      }
      const auto& readings = tracks_[stand.robot].map->submaps()[stands_[i].submap].readings;
      stand.heading = scene.heading_of(readings_of(
          readings, stands_[i].readings.first, stands_[i].readings.resting, T_team_stands_[i]));
    }
    add_features(matched, graph);
    for (const TeamRelation& one : relations) {
      graph.relations.push_back({stand_of(one.robot, one.submap),
                                 stand_of(one.peer, one.peer_submap),
                                 one.T_submap_peer,
                                 one.position_stddev_m,
                                 one.heading_stddev_rad});
    }
    return graph;
  }

  void add_features(const mapping::MatchedSurfaces& matched, slam::StopGraph& graph) const {
    for (const mapping::MatchedFeature& feature : matched.features) {
      slam::GraphFeature& added = graph.features.emplace_back();
      added.feature = feature.feature;
      for (const auto& [stop, index] : feature.supporters) {
        const ScanSurfaces& found = surfaces_of(stands_[first_stands_[stop]]);
        added.sightings.push_back({first_stands_[stop],
                                   found.center_m,
                                   found.surfaces[index].range_m,
                                   found.surfaces[index].bearing_rad});
      }
    }
  }

  std::size_t stand_of(std::size_t robot, std::size_t submap) const {
    return first_stands_[first_stops_[robot] + submap];
  }

  const TeamGraphParams& params_;
  std::vector<TeamTrack>& tracks_;
  std::vector<TeamStand> stands_;
  std::vector<Pose2> T_team_stands_;
  std::vector<std::size_t> first_stands_;  ///< Of each stop.
  std::vector<std::size_t> first_stops_;   ///< Of each robot.
  std::vector<slam::OdometryCalibration> calibrations_;
  slam::StopGraph last_;
};

}  // namespace

void validate(const TeamGraphParams& params) {
  geometry::ParameterValidator("team graph")
      .at_least("rounds", params.rounds, 1)
      .within("reading_weight", params.reading_weight, 0.001, 1.0);
  slam::validate(params.stands);
  slam::validate(params.heading);
  slam::validate(params.graph);
}

void align_team(const TeamGraphParams& params,
                const std::vector<TeamRelation>& relations,
                std::vector<TeamTrack>& tracks) {
  constexpr double kFirstToleranceFactor = 1.4;
  TeamStops stops(params, tracks);
  for (int round = 0; round < params.rounds; ++round) {
    slam::StopGraphParams graph = params.graph;
    if (round + 1 < params.rounds) {
      graph.odometry_scales = {graph.odometry_scales.back()};
    }
    stops.align(stops.match(round == 0 ? kFirstToleranceFactor : 1.0), relations, graph);
  }
  stops.take_home();
}

}  // namespace echomap::team_map
