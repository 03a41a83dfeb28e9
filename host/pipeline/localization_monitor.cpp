// SPDX-License-Identifier: MIT
#include "host/pipeline/localization_monitor.hpp"

#include <algorithm>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/scan_check.hpp"

namespace echomap::pipeline {

void validate(const LocalizationMonitorParams& params) {
  geometry::ParameterValidator("localization monitor")
      .positive("contradicting_echoes", params.contradicting_echoes)
      .within("contradicting_floor_share", params.contradicting_floor_share, 0.0, 1.0)
      .positive("contradictions_of_lost", params.contradictions_of_lost);
}

LocalizationMonitor::LocalizationMonitor(const mapping::RasterMap& map,
                                         localization::ObservationModel* places,
                                         double max_range_m,
                                         const LocalizationMonitorParams& params)
    : params_(params), map_(map), compared_map_(mapping::grid_of(map)) {
  validate(params);
  if (places != nullptr) {
    places_.emplace(*places);
    views_.emplace(map, max_range_m);
  }
}

void LocalizationMonitor::start_at(localization::LocalizerOutcome outcome) {
  if (places_ && outcome == localization::LocalizerOutcome::kMoved) {
    places_->begin_known();
  } else if (places_ && outcome == localization::LocalizerOutcome::kOffTheFloor) {
    places_->begin_anywhere();
  }
  contradictions_ = 0;
  doubtful_.reset();
}

void LocalizationMonitor::start_anywhere() {
  if (places_) {
    places_->begin_anywhere();
  }
  contradictions_ = 0;
  doubtful_.reset();
}

localization::CheckedBelief LocalizationMonitor::check(const localization::PoseBelief& believed,
                                                       const localization::StopScan& scan) {
  localization::CheckedBelief checked = places_ ? compare_places(*places_, believed, scan)
                                                : localization::CheckedBelief{believed, {}};
  localization::PoseBelief& belief = checked.belief;
  if (belief.status == localization::LocalizationStatus::kLocalized &&
      contradicts_place(belief.hypotheses.front().T_map_robot, scan.readings)) {
    belief.status = localization::LocalizationStatus::kRecovering;
  }
  doubtful_.reset();
  if (belief.status != localization::LocalizationStatus::kLocalized) {
    doubtful_ = belief;
    T_odom_checked_ = scan.T_odom_robot;
  }
  return checked;
}

localization::CheckedBelief LocalizationMonitor::compare_places(
    localization::PlaceCheck& places,
    const localization::PoseBelief& believed,
    const localization::StopScan& scan) {
  const auto contradicts = [&](const geometry::Pose2& T_map_robot) {
    return contradicts_place(T_map_robot, scan.readings);
  };
  const bool is_contradicted =
      !believed.hypotheses.empty() && contradicts(believed.hypotheses.front().T_map_robot);
  contradictions_ = is_contradicted ? contradictions_ + 1 : 0;
  if (contradictions_ >= params_.contradictions_of_lost) {
    places.doubt();
    contradictions_ = 0;
  }
  auto checked = places.check(believed, scan, contradicts);
  if (checked.T_map_restart) {
    contradictions_ = 0;
  }
  return checked;
}

void LocalizationMonitor::limit_confidence(localization::PoseBelief& belief,
                                           const geometry::Pose2& T_odom_robot) const {
  if (!doubtful_ || belief.status == localization::LocalizationStatus::kLost) {
    return;
  }
  belief.lost_probability = std::max(belief.lost_probability, doubtful_->lost_probability);
  if (belief.status == localization::LocalizationStatus::kLocalized) {
    belief.status = localization::LocalizationStatus::kRecovering;
  }
  if (places_ && !doubtful_->hypotheses.empty()) {
    const geometry::Pose2 T_checked_robot = T_odom_checked_.inverse() * T_odom_robot;
    belief.hypotheses = doubtful_->hypotheses;
    for (localization::PoseHypothesis& place : belief.hypotheses) {
      place.T_map_robot = place.T_map_robot * T_checked_robot;
    }
  }
}

double LocalizationMonitor::telling(const std::vector<localization::PoseHypothesis>& hypotheses,
                                    const geometry::Pose2& T_robot_goal) const {
  return views_ ? views_->telling(hypotheses, T_robot_goal) : 0.0;
}

bool LocalizationMonitor::contradicts_place(
    const geometry::Pose2& T_map_robot,
    const std::vector<localization::RangeReading>& readings) const {
  const geometry::Pose2 T_grid_robot =
      geometry::Pose2(-map_.origin_m().x(), -map_.origin_m().y(), 0.0) * T_map_robot;
  mapping::Scan scan;
  for (const localization::RangeReading& reading : readings) {
    scan.push_back({T_grid_robot, T_grid_robot * reading.T_robot_sensor, reading.range_m});
  }
  const mapping::ScanFit fit = mapping::fit_of(scan, compared_map_);
  const std::size_t known = fit.on_walls + fit.on_floor;
  return known >= params_.contradicting_echoes &&
         static_cast<double>(fit.on_floor) >
             params_.contradicting_floor_share * static_cast<double>(known);
}

}  // namespace echomap::pipeline
