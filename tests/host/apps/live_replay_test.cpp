// SPDX-License-Identifier: MIT
#include "host/apps/live_replay.hpp"

#include <string>

#include <gtest/gtest.h>

#include "host/pipeline/observation_fork.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/pipeline_setup.hpp"
#include "tests/host/apps/live_page_visit.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using live_page::MessageKind;

class LiveReplayTest : public testing::Test {
 protected:
  LiveReplayTest() {
    tests::WrittenRecording written(profile);
    written.add_stop(1.0);
    written.add_stop(1.2);
    written.save(file);
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path file = scratch / recording::kSessionFileName;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  pipeline::RobotAtlas atlas = session::atlas_for(profile, "multiscan");
};

TEST_F(LiveReplayTest, ShowsTheRunWhileItIsPlayedAndWhatItHasComeTo) {
  recording::SessionReader recording(file);
  testing::internal::CaptureStderr();
  LiveReplay live(page_at_any_port(), scratch / "again", recording, profile, atlas);
  const std::uint16_t port = port_in(testing::internal::GetCapturedStderr());
  pipeline::ObservationFork fork;
  fork.add(atlas);
  fork.add(live.sink());
  pipeline::JoinedSessions sessions(fork);
  std::size_t tiles_at_first_stop = 0;
  play(recording, profile, {sessions, atlas, &atlas}, {}, [&] {
    live.add_stop();
    if (tiles_at_first_stop == 0) {
      tiles_at_first_stop = of_kind(visited_history(port), MessageKind::kTile).size();
    }
  });
  EXPECT_GT(tiles_at_first_stop, 0U);
  live.end({"finished", ExitCode::kOk, "all was played", "look at it"});

  const auto history = visited_history(port);
  const auto hello = json_in(history.front());
  EXPECT_EQ(hello.at("name"), "again");
  EXPECT_EQ(hello.at("command"), "replay");
  EXPECT_EQ(hello.at("live"), true);
  EXPECT_EQ(of_kind(history, MessageKind::kTrail).size(), 2U);
  const auto state = json_in(of_kind(history, MessageKind::kState).back());
  EXPECT_EQ(state.at("mode"), "recording");
  EXPECT_EQ(state.at("stops"), 2);
  EXPECT_EQ(state.at("result").at("why"), "all was played");
  EXPECT_EQ(state.at("result").at("finished"), true);
}

}  // namespace
}  // namespace echomap::apps
