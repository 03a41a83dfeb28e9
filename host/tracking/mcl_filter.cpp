// SPDX-License-Identifier: MIT
#include "host/tracking/mcl_filter.hpp"

#include <utility>

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/console/print.hpp"
#include "host/tracking/localize_troubles.hpp"
#include "host/tracking/pose_report.hpp"

namespace echomap::tracking {

using localization::LocalizationStatus;

namespace {

/// Of a place that a person points at.
constexpr double kToldStddevM = 0.2;
constexpr double kToldStddevRad = 0.3;

}  // namespace

pipeline::RobotLocalizerParams localizer_params(const session::RobotProfile& profile,
                                                localization::LocalizerPreset preset) {
  pipeline::RobotLocalizerParams params;
  params.preset = preset;
  localization::LocalizedRobot& sonar = params.sensor.emplace();
  sonar.body_radius_m = profile.body_radius_m;
  sonar.beam_half_angle_rad = profile.beam_half_angle_rad;
  sonar.max_range_m = profile.range.max_range_m;
  return params;
}

MclFilter::MclFilter(const mapping::RasterMap& map,
                     const sensors::RobotGeometry& robot,
                     const pipeline::RobotLocalizerParams& params,
                     const std::optional<StartPose>& start,
                     std::mt19937 random)
    : start_(start), localizer_(map, robot, params, random) {}

void MclFilter::poll(const session::RobotSession& /*session*/) {
  if (localizer_.times_lifted() > lifts_told_) {
    lifts_told_ = localizer_.times_lifted();
    was_lifted_ = true;
    console::print("  lost: the robot was lifted and may be put down anywhere");
  }
  const auto trouble = trouble_of_start(localizer_.start_outcome());
  if (trouble && !std::exchange(start_is_told_, true)) {
    spdlog::warn("{}", *trouble);
  }
}

void MclFilter::begin(session::RobotSession& /*session*/) {
  if (start_) {
    localizer_.start_at(start_->T_map_robot, start_->stddev_m, start_->stddev_rad);
  }
}

std::optional<localization::PoseGaussian> MclFilter::estimate() const {
  const auto& hypotheses = localizer_.belief().hypotheses;
  return hypotheses.empty() ? std::nullopt
                            : std::optional(localization::PoseGaussian{
                                  hypotheses.front().T_map_robot, hypotheses.front().covariance});
}

void MclFilter::report_moved() {
  localizer_.start_anywhere();
  was_lifted_ = true;
}

void MclFilter::place(const geometry::Pose2& T_map_robot) {
  localizer_.start_at(T_map_robot, kToldStddevM, kToldStddevRad);
}

bool MclFilter::has_lost_it() {
  return std::exchange(was_lifted_, false) ||
         localizer_.belief().status == LocalizationStatus::kLost;
}

std::string MclFilter::line() const { return text_of(localizer_.belief()); }

nlohmann::ordered_json MclFilter::report() const {
  auto json = to_json(localizer_.belief());
  json["times_lifted"] = localizer_.times_lifted();
  return json;
}

}  // namespace echomap::tracking
