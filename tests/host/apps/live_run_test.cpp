// SPDX-License-Identifier: MIT
#include "host/apps/live_run.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/host/apps/live_run_on_a_cable.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::apps {
namespace {

using live_page::MessageKind;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class LiveRunTest : public LiveRunOnACable {
 protected:
  void stop() {
    robot.execute(exploration::BeginScan{});
    robot.execute(exploration::EndScan{});
  }
  void show_maps() {
    live->show(std::make_unique<AtlasSource>(robot.atlas(),
                                             nullptr,
                                             [this] {
                                               LiveProgress progress;
                                               progress.stops =
                                                   robot.atlas().pipeline().snapshot().stops;
                                               return progress;
                                             }),
               {},
               true);
  }
  std::vector<std::string> can() const {
    return json_in(messages(MessageKind::kHello).back()).at("can");
  }
};

TEST_F(LiveRunTest, ThatDoesNotServeDoesNothing) {
  LiveRun silent(LiveOptions(), robot, exploring());
  EXPECT_FALSE(silent.serves());
  EXPECT_FALSE(silent.may_be_watched());
  EXPECT_EQ(silent.url(), "");
  connect();
  EXPECT_EQ(robot.person(), nullptr) << "nobody can take the robot over";
  silent.score_against("nowhere");
  silent.look();
  silent.tell({"code", live_page::RunEvent::Level::kInfo, "text"});
  silent.end({"complete", ExitCode::kOk, "", ""});
}

TEST_F(LiveRunTest, SaysWhatTheRunIsBeforeItIsConnected) {
  serve();
  const auto hello = json_in(messages(MessageKind::kHello).front());
  EXPECT_EQ(hello.at("name"), "first_map");
  EXPECT_EQ(hello.at("command"), "explore");
  EXPECT_EQ(hello.at("version"), ECHOMAP_VERSION);
  EXPECT_EQ(hello.at("live"), true);
  EXPECT_EQ(hello.at("has_truth"), false);
  EXPECT_EQ(hello.at("robot"), "uno_2wd");
}

TEST_F(LiveRunTest, SaysWhichCommandsItTakes) {
  serve();
  EXPECT_THAT(can(), UnorderedElementsAre("stop", "drive", "explore"));
  live->show(nullptr, {.moved = [] {}}, true);
  EXPECT_THAT(can(), UnorderedElementsAre("stop", "drive", "explore", "moved", "go"));
  live->show(nullptr, {.moved = [] {}, .placed = [](const geometry::Pose2& /*pose*/) {}});
  EXPECT_THAT(can(), UnorderedElementsAre("stop", "drive", "explore", "moved", "pose"));
  live->show_nothing();
  EXPECT_THAT(can(), UnorderedElementsAre("stop", "drive", "explore"));
  serve(simulated());
  EXPECT_THAT(
      can(),
      UnorderedElementsAre("stop", "drive", "explore", "speed", "carry-off", "box", "cut-cable"));
}

TEST_F(LiveRunTest, ShowsTheStateOfTheLink) {
  serve();
  connect();
  EXPECT_EQ(state().at("mode"), "explore");
  EXPECT_EQ(state().at("link").at("state"), "ready");
  EXPECT_EQ(state().at("speed"), 1.0);
  EXPECT_THAT(events(), ElementsAre("link-ready"));
  cable.plugged = false;
  robot.execute(exploration::Stand{1.5});
  EXPECT_EQ(state().at("mode"), "lost-link");
  EXPECT_EQ(state().at("link").at("state"), "lost");
  EXPECT_THAT(events(), ElementsAre("link-ready", "link-lost"));
}

TEST_F(LiveRunTest, ShowsMotionsAndTheMapOfItsSource) {
  serve();
  connect();
  robot.execute(exploration::Stand{0.3});
  EXPECT_THAT(messages(MessageKind::kMotion), IsEmpty()) << "nothing says where it is";
  show_maps();
  stop();
  robot.execute(exploration::Stand{0.3});
  live->look();
  EXPECT_GE(messages(MessageKind::kMotion).size(), 3U) << "ten a second of its own time";
  EXPECT_EQ(messages(MessageKind::kTrail).size(), 1U);
  EXPECT_EQ(state().at("stops"), 1);
}

TEST_F(LiveRunTest, TellsNewMapsAndWhatOnlyTheCommandKnows) {
  serve();
  connect();
  show_maps();
  stop();
  live->look();
  robot.atlas().begin_new_map(0);
  live->look();
  live->tell({"carried-off", live_page::RunEvent::Level::kInfo, "somebody carries it off"});
  EXPECT_THAT(events(), ElementsAre("link-ready", "new-map", "carried-off"));
  EXPECT_EQ(messages(MessageKind::kNewMap).size(), 1U);
}

TEST_F(LiveRunTest, ScoresTheFirstMapAloneAndOnlyWhereThereIsATruth) {
  const tests::ScratchFolder truth;
  tests::write_truth_files(truth.path());
  serve();
  connect();
  show_maps();
  stop();
  EXPECT_TRUE(state().at("score").is_null());
  live->score_against(truth / "none");
  EXPECT_TRUE(state().at("score").is_null()) << "and the run goes on";
  live->score_against(truth.path());
  EXPECT_EQ(state().at("score").at("free_iou"), 0.0) << "nothing was seen";
  EXPECT_TRUE(state().at("score").at("pose_error_m").is_null()) << "the robot tells no truth";
  robot.atlas().begin_new_map(0);
  state();
  EXPECT_TRUE(state().at("score").is_null()) << "nothing says where the new map lies";
}

TEST_F(LiveRunTest, TellsHowTheRunHasEnded) {
  serve();
  connect();
  live->end({"complete", ExitCode::kOk, "all is seen", "echomap eval first_map"});
  EXPECT_EQ(state().at("mode"), "ended");
  EXPECT_EQ(state().at("result"), nlohmann::json::parse(R"({"finished": true,
    "outcome": "complete", "why": "all is seen", "next": "echomap eval first_map"})"));
}

TEST_F(LiveRunTest, SpeaksTheProtocolOfFoxglove) {
  serve();
  connect();
  for (const char* protocol : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    live_page::WebSocketClient client(port(), protocol);
    ASSERT_TRUE(client.is_open()) << protocol;
    EXPECT_EQ(nlohmann::json::parse(client.read_text()).at("op"), "serverInfo");
    EXPECT_EQ(nlohmann::json::parse(client.read_text()).at("op"), "advertise");
  }
}

TEST_F(LiveRunTest, LeavesTheRobotToItselfWhenItIsGone) {
  serve();
  connect();
  live.reset();
  EXPECT_EQ(robot.person(), nullptr);
  EXPECT_EQ(robot.execute(exploration::Drive{0.1}), exploration::MotionResult::kReached);
}

TEST_F(LiveRunTest, ThatCannotListenLeavesTheRobotAsItWas) {
  serve();
  const std::string taken = "127.0.0.1:" + std::to_string(port());
  session::RobotContext other(profile, session::Seed(1));
  other.begin_maps(session::kNoSlam);
  EXPECT_THROW(LiveRun({true, taken, false}, other, {}), console::CommandError);
  live.reset();
  other.open({new_connection(), nullptr});
  other.connect();
  EXPECT_EQ(other.execute(exploration::Drive{0.1}), exploration::MotionResult::kReached);
  EXPECT_EQ(other.person(), nullptr);
}

}  // namespace
}  // namespace echomap::apps
