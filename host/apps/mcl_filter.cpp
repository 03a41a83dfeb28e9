// SPDX-License-Identifier: MIT
#include "host/apps/mcl_filter.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/belief_report.hpp"
#include "host/apps/report.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::apps {

using localization::LocalizationStatus;

std::optional<StartPose> start_pose(const std::vector<double>& at) {
  constexpr std::size_t kNumbers = 3;
  if (at.size() != kNumbers) {
    return std::nullopt;
  }
  StartPose start;
  start.T_map_robot = {at[0], at[1], geometry::radians(at[2])};
  return start;
}

pipeline::RobotLocalizerParams localizer_params(const RobotProfile& profile,
                                                localization::LocalizerPreset preset) {
  pipeline::RobotLocalizerParams params;
  params.preset = preset;
  params.sonar.body_radius_m = profile.body_radius_m;
  params.sonar.half_opening_rad = profile.beam_half_angle_rad;
  params.sonar.max_range_m = profile.range.max_range_m;
  return params;
}

MclFilter::MclFilter(const mapping::RasterMap& map,
                     const sensors::RobotGeometry& robot,
                     const pipeline::RobotLocalizerParams& params,
                     const std::optional<StartPose>& start,
                     std::mt19937 random)
    : start_(start), localizer_(map, robot, params, random) {}

void MclFilter::poll(const RobotSession& /*session*/) {
  if (localizer_.times_lifted() > lifts_told_) {
    lifts_told_ = localizer_.times_lifted();
    was_lifted_ = true;
    say("  lost: the robot was lifted and may be put down anywhere");
  }
}

bool MclFilter::begin(RobotSession& /*session*/) {
  if (start_) {
    localizer_.start_at(start_->T_map_robot, start_->std_m, start_->std_rad);
  }
  return true;
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

}  // namespace echomap::apps
