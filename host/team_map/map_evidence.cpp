// SPDX-License-Identifier: MIT
#include "host/team_map/map_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/echo_feature.hpp"
#include "host/optimization/normal_equations.hpp"
#include "host/optimization/robust_kernel.hpp"

namespace echomap::team_map {

namespace {

using geometry::Pose2;
using mapping::CellState;

/// Of a surface that is matched with a feature: how far its range may be off in each step.
constexpr double kGatesM[] = {0.2, 0.14, 0.1, 0.1, 0.1};
constexpr double kGateM = 0.1;
constexpr double kGateRad = 0.26;
/// Farther surfaces are seen too rarely.
constexpr double kMaxRangeM = 3.0;
/// Standard deviations of a range and a bearing, as in slam::StopGraphParams.
constexpr double kRangeStddevM = 0.025;
constexpr double kMaxRangeErrorM = 0.08;
constexpr double kBearingStddevRad = 0.2;
/// Where nothing is known, six readings of ten have an echo, from anywhere within so far.
constexpr double kEchoShare = 0.6;
constexpr double kEchoesWithinM = 2.5;
/// A reading without an echo shows the floor up to here; this share of its path must be known.
constexpr double kSilenceRangeM = 2.0;
constexpr double kKnownShare = 0.9;
constexpr double kBeforeEchoM = 0.1;
constexpr double kStepM = 0.05;
/// An echo from so deep in the floor is from something that is not on the map.
constexpr double kFloorDepthM = 0.15;
/// A map knows of no surface before a sonar that it expects to have no echo with this chance or
/// more.
constexpr double kNoSurface = 0.7;
/// Readings of a sweep, about: those of a stop count as so many at most.
constexpr double kSweepReadings = 80.0;

/// A surface that one robot has seen, and the feature of the other's map that it may be.
struct SurfaceMatch {
  Eigen::Vector2d from_m;  ///< In the frame of the features.
  double range_m = 0.0;
  double bearing_rad = 0.0;
  bool is_matched = false;
  mapping::FeatureView view;  ///< Of the feature, if so.
};

/// What each surface of a scan would be for a sonar that points at it; the near ones.
mapping::Scan readings_of(const mapping::ScanSurfaces& scan, const Pose2& T_of_seer) {
  const Eigen::Vector2d from_m = T_of_seer * scan.center_m;
  mapping::Scan readings;
  for (const mapping::SonarSurface& surface : scan.surfaces) {
    if (surface.range_m <= kMaxRangeM) {
      const Pose2 T_of_sonar(from_m.x(),
                             from_m.y(),
                             geometry::wrap_angle(surface.bearing_rad + T_of_seer.heading_rad()));
      readings.push_back({T_of_sonar, T_of_sonar, surface.range_m});
    }
  }
  return readings;
}

SurfaceMatch matched_in(const RobotMap& of, const mapping::PlacedReading& surface, double gate_m) {
  SurfaceMatch match{surface.T_map_sonar.position_m(),
                     *surface.range_m,
                     surface.T_map_sonar.heading_rad(),
                     false,
                     {}};
  double nearest_off_m = gate_m;
  for (const mapping::MatchedFeature& feature : of.features().features) {
    const mapping::FeatureView view = mapping::view_from(match.from_m, feature.feature);
    const double off_m = std::abs(view.range_m - match.range_m);
    if (view.range_m > 0.0 && off_m < nearest_off_m &&
        std::abs(geometry::angle_between(view.bearing_rad, match.bearing_rad)) < kGateRad) {
      nearest_off_m = off_m;
      match.is_matched = true;
      match.view = view;
    }
  }
  return match;
}

/// Looks at what `seer` has seen in the map of `of`.
template <class Take>
void match_surfaces_in(const RobotMap& of,
                       const RobotMap& seer,
                       const Pose2& T_of_seer,
                       double gate_m,
                       const Take& take) {
  for (const mapping::ScanSurfaces& scan : seer.placed_surfaces()) {
    for (const mapping::PlacedReading& surface : readings_of(scan, T_of_seer)) {
      if (const SurfaceMatch match = matched_in(of, surface, gate_m); match.is_matched) {
        take(match);
      }
    }
  }
}

/// Normal equations of x, y and heading.
class PlacementEquations {
 public:
  PlacementEquations() {
    equations_.add_prior(Eigen::Vector3d::Zero(), 1e-3 * Eigen::Matrix3d::Identity());
  }
  void add(const SurfaceMatch& match, const Eigen::Vector3d& by_x, const Eigen::Vector3d& by_y) {
    const Eigen::Vector2d towards = geometry::unit_vector(match.view.bearing_rad);
    const double off_m = match.view.range_m - match.range_m;
    const double squared_error = geometry::square(off_m / kRangeStddevM);
    const double weight =
        optimization::geman_mcclure_weight(squared_error, kMaxRangeErrorM / kRangeStddevM) /
        geometry::square(kRangeStddevM);
    const Eigen::Vector3d by = -(towards.x() * by_x + towards.y() * by_y);
    equations_.add(off_m, by.transpose(), weight);
  }
  void add_bearing(const SurfaceMatch& match, double sign) {
    equations_.add(geometry::angle_between(match.bearing_rad, match.view.bearing_rad),
                   Eigen::RowVector3d(0.0, 0.0, -sign),
                   1.0 / geometry::square(kBearingStddevRad));
  }
  /// None where it is not finite.
  Eigen::Vector3d step() const { return equations_.solve().value_or(Eigen::Vector3d::Zero()); }

 private:
  optimization::NormalEquations<3> equations_;
};

Pose2 one_step(const RobotMap& first, const RobotMap& second, const Pose2& T, double gate_m) {
  PlacementEquations equations;
  const Eigen::Rotation2Dd turn(T.heading_rad());
  match_surfaces_in(first, second, T, gate_m, [&](const SurfaceMatch& match) {
    const Eigen::Vector2d arm_m = match.from_m - T.position_m();
    equations.add(match, {1.0, 0.0, -arm_m.y()}, {0.0, 1.0, arm_m.x()});
    equations.add_bearing(match, 1.0);
  });
  match_surfaces_in(second, first, T.inverse(), gate_m, [&](const SurfaceMatch& match) {
    const Eigen::Matrix2d back = -turn.inverse().toRotationMatrix();
    equations.add(match,
                  {back(0, 0), back(0, 1), match.from_m.y()},
                  {back(1, 0), back(1, 1), -match.from_m.x()});
    equations.add_bearing(match, -1.0);
  });
  const Eigen::Vector3d step = equations.step();
  return {T.x_m() + step.x(), T.y_m() + step.y(), T.heading_rad() + step.z()};
}

/// Whether the floor before the echo, or before where a reading has none, is known.
bool is_on_known_floor(const mapping::PlacedReading& reading, const mapping::RasterMap& map) {
  const double reach_m = reading.range_m.value_or(kSilenceRangeM) - kBeforeEchoM;
  int known = 0;
  int all = 0;
  const auto steps = static_cast<int>(reach_m / kStepM);
  for (int step = 1; step <= steps; ++step) {
    const CellState state =
        map.state(map.cell_at(reading.T_map_sonar * Eigen::Vector2d(step * kStepM, 0.0)));
    if (state == CellState::kOccupied) {
      break;
    }
    ++all;
    known += state == CellState::kFree ? 1 : 0;
  }
  return known >= kKnownShare * all;
}

mapping::Scan silenced(mapping::Scan scan) {
  for (mapping::PlacedReading& reading : scan) {
    reading.range_m.reset();
  }
  return scan;
}

/// Whether a map can confirm or contradict a reading. It cannot for an echo from beyond its floor
/// where it knows of no surface: it may have missed one, since walls answer only where they are met
/// squarely, and become features only once two stops have seen them.
bool is_testable(const mapping::PlacedReading& reading,
                 double silent_log_likelihood,
                 const mapping::PlaceableMap& of) {
  if (!is_on_known_floor(reading, of.map())) {
    return false;
  }
  return !reading.range_m || silent_log_likelihood <= std::log(kNoSurface) ||
         of.is_deep_in_floor(reading.T_map_sonar * Eigen::Vector2d(*reading.range_m, 0.0),
                             kFloorDepthM);
}

void add_readings(const RobotMap& of,
                  const RobotMap& seer,
                  const Pose2& T_of_seer,
                  MapEvidence& evidence) {
  const mapping::RasterMap& map = of.map().map();
  const double echo = std::log(kEchoShare / kEchoesWithinM);
  const double silence = std::log(1.0 - kEchoShare);
  for (std::size_t i = 0; i < seer.placed().scans.size(); ++i) {
    const Eigen::Vector2d from_m =
        T_of_seer * seer.placed().scans[i].front().T_map_sonar.position_m();
    if (map.state(map.cell_at(from_m)) != CellState::kFree) {
      continue;
    }
    const mapping::Scan scan = mapping::moved(seer.placed().scans[i], T_of_seer);
    const std::vector<double> log_likelihoods = of.scene().log_likelihoods_of(scan);
    const std::vector<double> if_silent = of.scene().log_likelihoods_of(silenced(scan));
    const double share = std::min(1.0, kSweepReadings / static_cast<double>(scan.size()));
    for (std::size_t k = 0; k < scan.size(); ++k) {
      if (is_testable(scan[k], if_silent[k], of.map())) {
        evidence.gain += share * (log_likelihoods[k] - (scan[k].range_m ? echo : silence));
        evidence.loss += share * (seer.own_log_likelihoods()[i][k] - log_likelihoods[k]);
        evidence.readings += share;
      }
    }
  }
}

void add_surfaces(const RobotMap& of,
                  const RobotMap& seer,
                  const Pose2& T_of_seer,
                  MapEvidence& evidence) {
  for (const mapping::ScanSurfaces& scan : seer.placed_surfaces()) {
    const mapping::Scan readings = readings_of(scan, T_of_seer);
    const std::vector<double> if_silent = readings.empty()
                                              ? std::vector<double>()
                                              : of.scene().log_likelihoods_of(silenced(readings));
    for (std::size_t k = 0; k < readings.size(); ++k) {
      if (is_testable(readings[k], if_silent[k], of.map())) {
        ++evidence.surfaces;
        evidence.matched += matched_in(of, readings[k], kGateM).is_matched ? 1 : 0;
      }
    }
  }
}

}  // namespace

Pose2 refined_placement(const RobotMap& first,
                        const RobotMap& second,
                        const Pose2& T_first_second) {
  Pose2 placement = T_first_second;
  for (const double gate_m : kGatesM) {
    placement = one_step(first, second, placement, gate_m);
  }
  return placement;
}

MapEvidence evidence_for(const RobotMap& first,
                         const RobotMap& second,
                         const Pose2& T_first_second) {
  MapEvidence evidence;
  add_readings(first, second, T_first_second, evidence);
  add_readings(second, first, T_first_second.inverse(), evidence);
  add_surfaces(first, second, T_first_second, evidence);
  add_surfaces(second, first, T_first_second.inverse(), evidence);
  return evidence;
}

}  // namespace echomap::team_map
