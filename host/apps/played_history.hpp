// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "host/apps/live_source.hpp"
#include "host/live_page/page_server.hpp"
#include "host/live_page/run_publisher.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// Publishes what a recording makes of the robot while it is played into an atlas.
class PlayedPublisher final : public pipeline::AnyObservationSink {
 public:
  /// All outlive this. It listens behind the atlas.
  PlayedPublisher(const recording::SessionReader& recording,
                  const session::RobotProfile& profile,
                  const pipeline::RobotAtlas& atlas,
                  std::shared_ptr<live_page::RunPublisher> publisher);

  void on(const sensors::Observation& observation) override;
  /// To be called at the end of each scan.
  void add_stop();
  /// To be called at the end.
  void end(const live_page::RunResult& result);

 private:
  LiveProgress progress() const;
  void add_state();

  const recording::SessionReader& recording_;
  const session::RobotProfile& profile_;
  const pipeline::RobotAtlas& atlas_;
  std::shared_ptr<live_page::RunPublisher> publisher_;
  AtlasSource source_;
  std::optional<exploration::Coverage> coverage_;
  std::optional<live_page::RunResult> result_;
  double next_motion_s_ = 0.0;
};

/// A finished run, played from its recording. Throws files::FileError and CommandError where it
/// has none that makes a map.
live_page::ServedRun played_run(const std::filesystem::path& run, const std::string& id);

}  // namespace echomap::apps
