// SPDX-License-Identifier: MIT
#include "host/apps/run_recording.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/recording/session_reader.hpp"
#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::apps {
namespace {

class RunRecordingTest : public session::SessionOnACable {
 protected:
  RunRecordingTest() { robot.open({new_connection(), nullptr}); }

  session::RobotContext robot{profile, session::Seed(7)};
  const tests::ScratchFolder out;
};

TEST_F(RunRecordingTest, SaysWhatTheRunIsAndWhatCameOfIt) {
  robot.connect();
  exports::RunSummary summary;
  summary.strategy = "frontier";
  begin_recording(robot, "explore", summary, out.path(), 0);
  files::write_text_file(out / "map.png", "picture");
  end_recording(
      robot, {{"outcome", "complete"}, {"finished", true}, {"wall_seconds", 3.5}}, out.path());
  recording::SessionReader reader(out / recording::kSessionFileName);
  EXPECT_EQ(reader.fact("session", "command"), "explore");
  EXPECT_EQ(reader.fact("session", "seed"), "7");
  EXPECT_EQ(reader.fact("session", "strategy"), "frontier");
  EXPECT_EQ(reader.fact("session", "firmware"), "echomap 0.1.0");
  EXPECT_EQ(reader.fact("session", "firmware_schema_digest"),
            reader.fact("session", "host_schema_digest"));
  reader.read_ending();
  EXPECT_EQ(reader.fact("ending", "outcome"), "complete");
  EXPECT_EQ(reader.fact("ending", "finished"), "true");
  EXPECT_EQ(reader.attachment("map.png"), "picture");
  EXPECT_FALSE(reader.attachment("map.pgm")) << "there was none";
  EXPECT_FALSE(nlohmann::json::parse(*reader.attachment("summary.json")).contains("wall_seconds"));
}

TEST_F(RunRecordingTest, EndsNothingThatWasNotBegun) {
  end_recording(robot, {}, out.path());
  EXPECT_FALSE(exists(out / recording::kSessionFileName));
}

TEST(SplitBytes, AreMegabytes) {
  RunOptions run;
  EXPECT_EQ(split_bytes(run), 0U);
  run.split_mb = 2;
  EXPECT_EQ(split_bytes(run), 2'000'000U);
}

}  // namespace
}  // namespace echomap::apps
