// SPDX-License-Identifier: MIT
/// What readers by others (validate.mjs) make of the recording of a run.
#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
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

class SessionPeers : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(ECHOMAP_MCAP_PEERS "/installed")) {
      GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
    }
  }
  structure::ShellResult run_script(const std::string& name,
                                    const std::filesystem::path& file) const {
    return structure::run_shell(
        "node " + shell_quoted(ECHOMAP_MCAP_PEERS "/" + name) + " " + shell_quoted(file),
        scratch.path());
  }

  const tests::ScratchFolder scratch;
};

TEST_F(SessionPeers, DecodeEveryChannelOfARecordedRun) {
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
  const auto validated = run_script("validate.mjs", run / "session.mcap");
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

TEST_F(SessionPeers, WriteABagThatIsMapped) {
  const auto written = run_script("write_bag.mjs", scratch / "room.mcap");
  ASSERT_EQ(written.exit_code, 0) << written.output;
  const Ended ended = Program("echomap",
                              {"replay",
                               (scratch / "room.mcap").string(),
                               "--headless",
                               "--out=" + (scratch / "room").string()},
                              scratch / "log")
                          .wait();
  ASSERT_EQ(ended.status, 0) << ended.said;
  const json summary = json::parse(files::read_text_file(scratch / "room" / "summary.json"));
  EXPECT_NEAR(summary.at("free_area_m2"), 6.0, 0.8) << "of a room of 3 x 2 m";
  EXPECT_EQ(summary.at("replay").at("scans"), 63 * 5);
}

}  // namespace
}  // namespace echomap::test
