// SPDX-License-Identifier: MIT
#include "host/apps/live_replay.hpp"

#include "host/apps/served_page.hpp"

namespace echomap::apps {
namespace {

std::shared_ptr<live_page::RunPublisher> replay_publisher(const std::filesystem::path& out,
                                                          const session::RobotProfile& profile) {
  live_page::RunFacts facts;
  facts.name = out.filename().string();
  facts.version = ECHOMAP_VERSION;
  facts.command = "replay";
  facts.live = true;
  return std::make_shared<live_page::RunPublisher>(
      std::make_shared<live_page::History>(), facts, profile);
}

}  // namespace

LiveReplay::LiveReplay(const LiveOptions& options,
                       const std::filesystem::path& out,
                       const recording::SessionReader& recording,
                       const session::RobotProfile& profile,
                       const pipeline::RobotAtlas& atlas)
    : publisher_(replay_publisher(out, profile)),
      published_(recording, profile, atlas, publisher_),
      server_(serve_page(options, {{out.filename().string(), out, publisher_->history(), true}})) {}

void LiveReplay::end(const RunEnding& ending) {
  published_.end({ending.finished(), ending.outcome, ending.why, ending.next});
  wait_while_watched(*server_);
}

}  // namespace echomap::apps
