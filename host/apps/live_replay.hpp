// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/apps/commands.hpp"
#include "host/apps/played_history.hpp"
#include "host/apps/run_ending.hpp"
#include "host/live_page/page_server.hpp"

namespace echomap::apps {

/// The live page of a recording while it is played.
class LiveReplay {
 public:
  /// All but the options and `out`, the run directory that is written, outlive this. Throws
  /// CommandError where it cannot listen.
  LiveReplay(const LiveOptions& options,
             const std::filesystem::path& out,
             const recording::SessionReader& recording,
             const session::RobotProfile& profile,
             const pipeline::RobotAtlas& atlas);

  /// What the recording is played into, behind the atlas.
  PlayedPublisher& sink() { return published_; }
  /// To be called at the end of each scan.
  void add_stop() { published_.add_stop(); }
  /// Says how the replay has ended, and serves on as long as somebody watches, until Ctrl-C.
  void end(const RunEnding& ending);

 private:
  std::shared_ptr<live_page::RunPublisher> publisher_;
  PlayedPublisher published_;
  std::unique_ptr<live_page::PageServer> server_;
};

}  // namespace echomap::apps
