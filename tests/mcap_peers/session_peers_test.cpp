// SPDX-License-Identifier: MIT
/// What readers by others (validate.mjs) make of the recording of a run.
#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/programs.hpp"
#include "tests/structure/shell.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using nlohmann::json;
using structure::shell_quoted;
using testing::IsSupersetOf;

/// The types by which tools know what to show.
const std::map<std::string, std::string> kTopics{
    {"/odom", "nav_msgs/msg/Odometry"},
    {"/tf", "tf2_msgs/msg/TFMessage"},
    {"/sonar", "sensor_msgs/msg/Range"},
    {"/sonar/cone", "visualization_msgs/msg/MarkerArray"},
    {"/scan", "sensor_msgs/msg/LaserScan"},
    {"/map", "nav_msgs/msg/OccupancyGrid"},
    {"/path", "nav_msgs/msg/Path"},
    {"/pose", "geometry_msgs/msg/PoseWithCovarianceStamped"},
    {"/map/features", "visualization_msgs/msg/MarkerArray"},
    {"/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"},
    {"/robot/frames_received", "echomap_msgs/msg/LineFrame"},
    {"/robot/frames_sent", "echomap_msgs/msg/LineFrame"},
    {"/session/events", "echomap_msgs/msg/SessionEvent"},
};

TEST(SessionPeers, DecodeEveryChannelOfARecordedRun) {
  if (!std::filesystem::exists(ECHOMAP_MCAP_PEERS "/installed")) {
    GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
  }
  const tests::ScratchFolder scratch;
  const auto run = scratch / "run";
  EXPECT_EQ(Program("echomap",
                    {"demo",
                     "--emulator=mock",
                     "--headless",
                     "--no-kidnap",
                     "--stops=2",
                     "--out=" + run.string()},
                    scratch / "log")
                .wait()
                .status,
            kUnfinished);
  const auto validated =
      structure::run_shell("node " + shell_quoted(ECHOMAP_MCAP_PEERS "/validate.mjs") + " " +
                               shell_quoted(run / "session.mcap"),
                           scratch.path());
  ASSERT_EQ(validated.exit_code, 0) << validated.output;
  const json found = json::parse(validated.output);
  EXPECT_TRUE(found.at("indexed_equals_streamed"));
  for (const auto& [topic, type] : kTopics) {
    ASSERT_TRUE(found.at("channels").contains(topic)) << topic;
    EXPECT_EQ(found.at("channels").at(topic).at("schema"), type);
    EXPECT_GT(found.at("channels").at(topic).at("messages"), 0) << topic;
  }
  EXPECT_EQ(found.at("channels").at("/odom").at("first").at("child_frame_id"), "base_link");
  EXPECT_EQ(found.at("channels").at("/map").at("first").at("header").at("frame_id"), "map");
  EXPECT_THAT(found.at("attachments"),
              IsSupersetOf({"robot.toml", "summary.json", "map.pgm", "map.yaml", "map.png"}));
  EXPECT_THAT(found.at("metadata"), IsSupersetOf({"session", "ending"}));
}

}  // namespace
}  // namespace echomap::test
