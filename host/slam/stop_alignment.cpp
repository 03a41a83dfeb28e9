// SPDX-License-Identifier: MIT
#include "host/slam/stop_alignment.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/slam/leave_one_out.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;
using mapping::MatchedSurfaces;
using mapping::ScanSurfaces;

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
      .positive("wide_every", params.wide_every)
      .at_least("wide_window", params.wide_window, params.window)
      .positive("tried_drift_rad_per_m", params.tried_drift_rad_per_m)
      .positive("reading_weight", params.reading_weight)
      .at_least("min_gain", params.min_gain, 0.0)
      .positive("same_start_rad", params.same_start_rad)
      .positive("same_start_m", params.same_start_m);
  validate(params.stands);
  validate(params.heading);
  validate(params.graph);
}

void StopAlignment::add_stop(std::vector<StopReading> readings) {
  const auto stands = stands_in(readings, stops_.size(), params_.stands);
  stands_.insert(stands_.end(), stands.begin(), stands.end());
  T_map_stands_.resize(stands_.size());
  stops_.push_back(std::move(readings));
  surfaces_.emplace_back();
}

void StopAlignment::align(const std::vector<Pose2>& T_slam_stands) {
  const std::size_t window =
      stops_.size() % params_.wide_every == 0 ? params_.wide_window : params_.window;
  const std::size_t first_free = stops_.size() > window ? stops_.size() - window : 0;
  const OdometryCalibration calibration = calibration_;
  std::optional<Placement> best;
  for (const std::vector<Pose2>& start : starts(first_free, T_slam_stands)) {
    Placement placement = aligned_from(start, calibration, first_free);
    if (!best || placement.log_likelihood > best->log_likelihood + params_.min_gain) {
      best = std::move(placement);
    }
  }
  T_map_stands_ = best->T_map_stands;
  calibration_ = best->calibration;
}

StopAlignment::Placement StopAlignment::aligned_from(const std::vector<Pose2>& T_map_stands,
                                                     const OdometryCalibration& calibration,
                                                     std::size_t first_free) {
  T_map_stands_ = T_map_stands;
  calibration_ = calibration;
  if (stops_.size() == 1) {
    return {T_map_stands_, calibration_};
  }
  const std::vector<std::size_t> stops = stops_around(first_free);
  StopGraph graph;
  for (int round = 0; round < params_.rounds; ++round) {
    graph = align_once(stops, first_free, round);
  }
  return {T_map_stands_,
          calibration_,
          params_.reading_weight * log_likelihood_of(stops) - odometry_cost(params_.graph, graph)};
}

double StopAlignment::log_likelihood_of(const std::vector<std::size_t>& stops) {
  const MatchedSurfaces matched = match(stops, 1.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const SonarScene scene(features_of_others(matched, k), params_.heading);
    for (std::size_t i = first_stand_of(stops[k]);
         i < stands_.size() && stands_[i].stop == stops[k];
         ++i) {
      sum += scene.log_likelihood_of(resting_readings_of(i));
    }
  }
  return sum;
}

std::size_t StopAlignment::first_stand_of(std::size_t stop) const {
  const auto found =
      std::lower_bound(stands_.begin(), stands_.end(), stop, [](const StopStand& stand, auto of) {
        return stand.stop < of;
      });
  return static_cast<std::size_t>(found - stands_.begin());
}

std::vector<std::vector<Pose2>> StopAlignment::starts(
    std::size_t first_free, const std::vector<Pose2>& T_slam_stands) const {
  std::vector<std::vector<Pose2>> starts{start_by_slam(first_free, T_slam_stands, 0.0)};
  const auto add = [&](std::vector<Pose2> start) {
    if (std::none_of(starts.begin(), starts.end(), [&](const auto& other) {
          return are_near(start, other, params_.same_start_m, params_.same_start_rad);
        })) {
      starts.push_back(std::move(start));
    }
  };
  if (stops_.size() > 2) {  // Two stops share no feature that two others support.
    add(start_by_last_alignment());
    if (stops_.size() <= params_.drift_tried_stops) {
      add(start_by_slam(first_free, T_slam_stands, -params_.tried_drift_rad_per_m));
      add(start_by_slam(first_free, T_slam_stands, params_.tried_drift_rad_per_m));
    }
  }
  return starts;
}

std::vector<Pose2> StopAlignment::start_by_slam(std::size_t first_free,
                                                const std::vector<Pose2>& T_slam_stands,
                                                double drift_rad_per_m) const {
  const OdometryCalibration drift{{0.0, drift_rad_per_m, 0.0}};
  std::vector<Pose2> start = T_map_stands_;
  for (std::size_t i = first_stand_of(first_free); i < stands_.size(); ++i) {
    if (i == 0) {
      start[i] = T_slam_stands[0];
      continue;
    }
    OdometryPiece piece = odometry_before(i);
    piece.T_before_after = T_slam_stands[i - 1].inverse() * T_slam_stands[i];
    start[i] = start[i - 1] * calibrated(piece, drift);
  }
  return start;
}

std::vector<Pose2> StopAlignment::start_by_last_alignment() const {
  std::vector<Pose2> start = T_map_stands_;
  for (std::size_t i = first_stand_of(stops_.size() - 1); i < stands_.size(); ++i) {
    start[i] = start[i - 1] * calibrated(odometry_before(i), calibration_);
  }
  return start;
}

OdometryPiece StopAlignment::odometry_before(std::size_t stand) const {
  const auto mark_at = [&](const StopStand& of) -> const OdometryMark& {
    return stops_[of.stop][of.first].mark;
  };
  return piece_between(mark_at(stands_[stand - 1]), mark_at(stands_[stand]));
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
  stops.reserve(held.size() + stops_.size() - first_free + 1);
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
  return surfaces_[stop].find(T_first_stands,
                              mapping::moved(readings_of(stop), T_map_stands_[first].inverse()),
                              params_.surfaces);
}

MatchedSurfaces StopAlignment::match(const std::vector<std::size_t>& stops,
                                     double tolerance_factor) {
  std::vector<ScanSurfaces> placed;
  placed.reserve(stops.size());
  for (const std::size_t stop : stops) {
    placed.push_back(moved(surfaces_of(stop), T_map_stands_[first_stand_of(stop)]));
  }
  return match_surfaces(placed, widened(params_.matching, tolerance_factor));
}

StopGraph StopAlignment::align_once(const std::vector<std::size_t>& stops,
                                    std::size_t first_free,
                                    int round) {
  const MatchedSurfaces matched = match(stops, round == 0 ? params_.first_tolerance_factor : 1.0);
  StopGraph graph = graph_over(stops, first_free, matched);
  StopGraphParams graph_params = params_.graph;
  if (round + 1 < params_.rounds) {  // What poor matches say of the odometry is no measurement.
    graph_params.odometry_scales = {graph_params.odometry_scales.back()};
  }
  align_stops(graph_params, graph);
  calibration_ = graph.calibrations.front();
  std::size_t node = 0;
  for (const std::size_t stop : stops) {
    for (std::size_t i = first_stand_of(stop); i < stands_.size() && stands_[i].stop == stop; ++i) {
      T_map_stands_[i] = graph.stands[node++].T_map_robot;
    }
  }
  return graph;
}

StopGraph StopAlignment::graph_over(const std::vector<std::size_t>& stops,
                                    std::size_t first_free,
                                    const MatchedSurfaces& matched) const {
  const SonarScene scene(matched, params_.heading);
  StopGraph graph;
  graph.calibrations = {calibration_};
  std::vector<std::size_t> first_nodes;
  std::optional<std::size_t> before;
  for (const std::size_t stop : stops) {
    first_nodes.push_back(graph.stands.size());
    for (std::size_t i = first_stand_of(stop); i < stands_.size() && stands_[i].stop == stop; ++i) {
      GraphStand& stand = graph.stands.emplace_back();
      stand.T_map_robot = T_map_stands_[i];
      stand.is_free = stop >= first_free;
      if (i > 0 && before == i - 1) {
        stand.piece_before = odometry_before(i);
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
      const ScanSurfaces& found = surfaces_[stops[scan]].last();
      added.sightings.push_back({first_nodes[scan],
                                 found.center_m,
                                 found.surfaces[index].range_m,
                                 found.surfaces[index].bearing_rad});
    }
  }
  return graph;
}

}  // namespace echomap::slam
