// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "host/mapping/raster_map.hpp"
#include "host/pipeline/robot_localizer.hpp"
#include "host/session/robot_profile.hpp"
#include "host/tracking/live_filter.hpp"
#include "host/tracking/start_pose.hpp"

namespace echomap::tracking {

/// A preset with what it has to know of a robot: by its sonar, its ring of infra-red sensors or, of
/// a robot with neither, its contacts. Throws CommandError where the preset needs another sensor.
pipeline::RobotLocalizerParams localizer_params(const session::RobotProfile& profile,
                                                localization::LocalizerPreset preset);

/// Monte-Carlo localization in a map.
class MclFilter final : public LiveFilter {
 public:
  /// Anywhere without `start`. Throws std::invalid_argument for invalid settings or an invalid map.
  MclFilter(const mapping::RasterMap& map,
            const sensors::RobotGeometry& robot,
            const pipeline::RobotLocalizerParams& params,
            const std::optional<StartPose>& start,
            std::mt19937 random);

  pipeline::ObservationSink& sink() override { return localizer_; }
  void poll(const session::RobotSession& session) override;
  void begin(session::RobotSession& session) override;
  bool has_lost_it() override;
  double telling(const geometry::Pose2& T_robot_goal) const override {
    return localizer_.telling(T_robot_goal);
  }
  std::optional<localization::PoseGaussian> estimate() const override;
  const localization::PoseBelief* hypotheses() const override { return &localizer_.belief(); }
  /// Somebody says that it was moved, or where it is.
  void report_moved();
  void place(const geometry::Pose2& T_map_robot);
  std::vector<geometry::Pose2> sampled_poses(std::size_t count) const override {
    return localizer_.sampled_poses(count);
  }
  std::string line() const override;
  nlohmann::ordered_json report() const override;
  const std::vector<pipeline::StampedPose>& trajectory() const override {
    return localizer_.trajectory();
  }

  pipeline::RobotLocalizer& localizer() { return localizer_; }

 private:
  std::optional<StartPose> start_;
  pipeline::RobotLocalizer localizer_;
  bool start_is_told_ = false;  ///< It cannot be.
  std::size_t lifts_told_ = 0;
  bool was_lifted_ = false;  ///< Since the last stop.
};

}  // namespace echomap::tracking
