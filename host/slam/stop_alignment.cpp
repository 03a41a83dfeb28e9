// SPDX-License-Identifier: MIT
#include "host/slam/stop_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;
using mapping::MatchedSurfaces;
using mapping::ScanSurfaces;

/// A stop that is bent by less keeps the surfaces that were found in it.
constexpr double kBentRad = 0.012;
constexpr double kBentM = 0.005;

bool is_near(const Pose2& one, const Pose2& other, double near_m, double near_rad) {
  const Pose2 T_one_other = one.inverse() * other;
  return T_one_other.position_m().norm() <= near_m &&
         std::abs(T_one_other.heading_rad()) <= near_rad;
}

/// Readings from `first` on that were taken where that one was.
std::size_t resting_from(const std::vector<StopReading>& readings,
                         std::size_t first,
                         const StopAlignmentParams& params) {
  std::size_t count = 1;
  while (first + count < readings.size() && is_near(readings[first].mark.T_odom_robot,
                                                    readings[first + count].mark.T_odom_robot,
                                                    params.same_m,
                                                    params.same_rad)) {
    ++count;
  }
  return count;
}

std::vector<StopStand> stands_in(const std::vector<StopReading>& readings,
                                 std::size_t stop,
                                 const StopAlignmentParams& params) {
  std::vector<StopStand> stands;
  for (std::size_t first = 0; first < readings.size();) {
    const std::size_t resting = resting_from(readings, first, params);
    if (stands.empty() || resting >= params.heading.min_readings) {
      stands.push_back({stop, first, resting, first + resting});
    }
    first += resting;
    stands.back().last = first;
  }
  return stands;
}

mapping::SurfaceMatchingParams widened(mapping::SurfaceMatchingParams params, double factor) {
  params.wall_bearing_tolerance_rad *= factor;
  params.post_bearing_tolerance_rad *= factor;
  return params;
}

}  // namespace

StopAlignment::StopAlignment(const StopAlignmentParams& params) : params_(params) {
  geometry::ParameterValidator("stop alignment")
      .at_least("first_tolerance_factor", params.first_tolerance_factor, 1.0)
      .at_least("rounds", params.rounds, 1)
      .at_least("window", params.window, 2)
      .positive("same_rad", params.same_rad)
      .positive("same_m", params.same_m);
  validate(params.heading);
  validate(params.graph);
}

void StopAlignment::add_stop(std::vector<StopReading> readings) {
  const auto stands = stands_in(readings, stops_.size(), params_);
  stands_.insert(stands_.end(), stands.begin(), stands.end());
  T_map_stands_.resize(stands_.size());
  stops_.push_back(std::move(readings));
  found_.emplace_back();
}

void StopAlignment::align(const std::vector<Pose2>& T_slam_stands) {
  const std::size_t first_free =
      stops_.size() > params_.window ? stops_.size() - params_.window : 0;
  predict(first_free, T_slam_stands);
  const std::vector<std::size_t> stops = stops_around(first_free);
  for (int round = 0; round < params_.rounds && stops_.size() > 1; ++round) {
    align_once(stops, first_free, round);
  }
}

std::size_t StopAlignment::first_stand_of(std::size_t stop) const {
  const auto found =
      std::lower_bound(stands_.begin(), stands_.end(), stop, [](const StopStand& stand, auto of) {
        return stand.stop < of;
      });
  return static_cast<std::size_t>(found - stands_.begin());
}

void StopAlignment::predict(std::size_t first_free, const std::vector<Pose2>& T_slam_stands) {
  for (std::size_t i = first_stand_of(first_free); i < stands_.size(); ++i) {
    T_map_stands_[i] =
        i == 0 ? T_slam_stands[0]
               : T_map_stands_[i - 1] * T_slam_stands[i - 1].inverse() * T_slam_stands[i];
  }
}

std::vector<std::size_t> StopAlignment::stops_around(std::size_t first_free) const {
  const auto place_m = [&](std::size_t stop) {
    return T_map_stands_[first_stand_of(stop)].position_m();
  };
  std::vector<std::pair<double, std::size_t>> held;
  for (std::size_t stop = 0; stop + 1 < first_free; ++stop) {
    double nearest_m = (place_m(stop) - place_m(first_free)).norm();
    for (std::size_t free = first_free + 1; free < stops_.size(); ++free) {
      nearest_m = std::min(nearest_m, (place_m(stop) - place_m(free)).norm());
    }
    held.emplace_back(nearest_m, stop);
  }
  std::sort(held.begin(), held.end());
  held.resize(std::min(held.size(), params_.holders));
  std::vector<std::size_t> stops;
  for (const auto& [nearest_m, stop] : held) {
    stops.push_back(stop);
  }
  for (std::size_t stop = first_free == 0 ? 0 : first_free - 1; stop < stops_.size(); ++stop) {
    stops.push_back(stop);
  }
  std::sort(stops.begin(), stops.end());
  return stops;
}

mapping::Scan StopAlignment::readings_of(std::size_t stop) const {
  mapping::Scan scan;
  for (std::size_t i = first_stand_of(stop); i < stands_.size() && stands_[i].stop == stop; ++i) {
    const auto& readings = stops_[stop];
    const Pose2 T_map_odom =
        T_map_stands_[i] * readings[stands_[i].first].mark.T_odom_robot.inverse();
    for (std::size_t k = stands_[i].first; k < stands_[i].last; ++k) {
      const Pose2 T_map_robot = T_map_odom * readings[k].mark.T_odom_robot;
      scan.push_back({T_map_robot, T_map_robot * readings[k].T_robot_sonar, readings[k].range_m});
    }
  }
  return scan;
}

mapping::Scan StopAlignment::resting_readings_of(std::size_t stand) const {
  const mapping::Scan scan = readings_of(stands_[stand].stop);
  const auto first = scan.begin() + static_cast<std::ptrdiff_t>(stands_[stand].first);
  return {first, first + static_cast<std::ptrdiff_t>(stands_[stand].resting)};
}

std::vector<mapping::Scan> StopAlignment::scans() const {
  std::vector<mapping::Scan> scans;
  for (std::size_t stop = 0; stop < stops_.size(); ++stop) {
    scans.push_back(readings_of(stop));
  }
  return scans;
}

const ScanSurfaces& StopAlignment::surfaces_of(std::size_t stop) {
  const std::size_t first = first_stand_of(stop);
  std::vector<Pose2> T_first_stands;
  for (std::size_t i = first; i < stands_.size() && stands_[i].stop == stop; ++i) {
    T_first_stands.push_back(T_map_stands_[first].inverse() * T_map_stands_[i]);
  }
  FoundSurfaces& found = found_[stop];
  const bool is_bent =
      !std::equal(T_first_stands.begin(),
                  T_first_stands.end(),
                  found.T_first_stands.begin(),
                  found.T_first_stands.end(),
                  [](const Pose2& a, const Pose2& b) { return is_near(a, b, kBentM, kBentRad); });
  if (is_bent) {
    const mapping::Scan scan = mapping::moved(readings_of(stop), T_map_stands_[first].inverse());
    found = {T_first_stands, find_surfaces(scan, params_.surfaces)};
  }
  return found.surfaces;
}

void StopAlignment::align_once(const std::vector<std::size_t>& stops,
                               std::size_t first_free,
                               int round) {
  std::vector<ScanSurfaces> placed;
  placed.reserve(stops.size());
  for (const std::size_t stop : stops) {
    placed.push_back(moved(surfaces_of(stop), T_map_stands_[first_stand_of(stop)]));
  }
  const double factor = round == 0 ? params_.first_tolerance_factor : 1.0;
  const auto matched = match_surfaces(placed, widened(params_.matching, factor));
  StopGraph graph = graph_over(stops, first_free, matched);
  StopGraphParams graph_params = params_.graph;
  if (round + 1 < params_.rounds) {  // What poor matches say of the odometry is no measurement.
    graph_params.odometry_scales = {graph_params.odometry_scales.back()};
  }
  align_stops(graph_params, graph);
  calibration_ = graph.calibration;
  std::size_t node = 0;
  for (const std::size_t stop : stops) {
    for (std::size_t i = first_stand_of(stop); i < stands_.size() && stands_[i].stop == stop; ++i) {
      T_map_stands_[i] = graph.stands[node++].T_map_robot;
    }
  }
}

StopGraph StopAlignment::graph_over(const std::vector<std::size_t>& stops,
                                    std::size_t first_free,
                                    const MatchedSurfaces& matched) const {
  const SonarScene scene(matched, params_.heading);
  StopGraph graph;
  graph.calibration = calibration_;
  std::vector<std::size_t> first_nodes;
  std::optional<std::size_t> before;
  for (const std::size_t stop : stops) {
    first_nodes.push_back(graph.stands.size());
    for (std::size_t i = first_stand_of(stop); i < stands_.size() && stands_[i].stop == stop; ++i) {
      GraphStand& stand = graph.stands.emplace_back();
      stand.T_map_robot = T_map_stands_[i];
      stand.is_free = stop >= first_free;
      if (i > 0 && before == i - 1) {
        const StopStand& last = stands_[i - 1];
        stand.piece_before =
            piece_between(stops_[last.stop][last.first].mark, stops_[stop][stands_[i].first].mark);
      }
      if (stand.is_free) {
        stand.heading = scene.heading_of(resting_readings_of(i));
      }
      before = i;
    }
  }
  for (const mapping::MatchedFeature& feature : matched.features) {
    GraphFeature& added = graph.features.emplace_back();
    added.feature = feature.feature;
    for (const auto& [scan, index] : feature.supporters) {
      const FoundSurfaces& found = found_[stops[scan]];
      added.sightings.push_back({first_nodes[scan],
                                 found.surfaces.center_m,
                                 found.surfaces.surfaces[index].range_m,
                                 found.surfaces.surfaces[index].bearing_rad});
    }
  }
  return graph;
}

}  // namespace echomap::slam
