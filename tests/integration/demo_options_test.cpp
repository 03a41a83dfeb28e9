// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using files::read_text_file;
using files::write_text_file;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
namespace fs = std::filesystem;

/// `text` with the first `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// The demo on the native mock.
class DemoOptions : public ::testing::Test {
 protected:
  std::vector<std::string> demo(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{
        "demo", "--emulator=mock", "--force", "--out=" + path("run")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Ended run(const std::vector<std::string>& more) {
    return Program("echomap", demo(more), scratch / "log").wait();
  }
  std::string path(const std::string& name) const { return (scratch / name).string(); }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(read_text_file(scratch / name));
  }

  const std::string profile_text = read_text_file(ECHOMAP_SOURCE_DIR "/host/profiles/uno_2wd.toml");
  const std::string body_text = read_text_file(ECHOMAP_SOURCE_DIR "/hil_mock/robots/uno_2wd.toml");
  tests::ScratchFolder scratch;
};

TEST_F(DemoOptions, AProfileOfOnesOwnDrivesTheBodyOfItsName) {
  write_text_file(path("robot.toml"), profile_text);
  const Ended ended = run({"--stops=1", "--robot=" + path("robot.toml")});
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/summary.json").at("robot"), "uno_2wd");
}

TEST_F(DemoOptions, ABodyOfOnesOwnIsWhatTheHostDoesNotKnowOf) {
  write_text_file(path("robot.toml"), with(profile_text, "\"uno_2wd\"", "\"mine\""));
  write_text_file(path("body.toml"), with(body_text, "track_m = 0.140", "track_m = 0.160"));
  // With a strategy whose first stop does not measure how far the body turns.
  const std::vector<std::string> options{
      "--stops=1", "--robot=" + path("robot.toml"), "--strategy=nxt-farthest"};
  const Ended bodyless = run(options);
  EXPECT_EQ(bodyless.status, 6);
  EXPECT_THAT(bodyless.said,
              AllOf(HasSubstr("no body (--body) is named 'mine'"), HasSubstr("next: ")));

  const Ended ended = run({options[0], options[1], options[2], "--body=" + path("body.toml")});
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/summary.json").at("robot"), "mine");
  // A scan turns the body round by half a turn; the wider track makes that an eighth less.
  EXPECT_GT(json("run/summary.json").at("ate_heading_rmse_rad"), 0.1);
}

TEST_F(DemoOptions, ABrokenBodyIsPlaced) {
  write_text_file(path("body.toml"), with(body_text, "track_m", "trakc_m"));
  const Ended ended = run({"--body=" + path("body.toml")});
  EXPECT_EQ(ended.status, 6);
  EXPECT_THAT(ended.said, StartsWith("echomap: error: " + path("body.toml") + ":"));
  EXPECT_THAT(ended.said, Not(HasSubstr("\n\n")));
}

TEST_F(DemoOptions, TheScoresStandInTheRunDirectoryToo) {
  const Ended ended = run({"--stops=1", "--json=" + path("report.json")});
  ASSERT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_GT(json("run/summary.json").at("free_iou"), 0.1);
  EXPECT_EQ(json("run/summary.json"), json("report.json"));
}

TEST_F(DemoOptions, MapsOverAPoorRadioLine) {
  const Ended ended = run({"--stops=3", "--line=bluetooth", "--faults=loss=0.02"});
  ASSERT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/summary.json").at("stops"), 3);
  EXPECT_GT(json("run/summary.json").at("free_iou"), 0.1);
  const Ended wrong = run({"--faults=flop=1"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.said, HasSubstr("flop"));
}

TEST_F(DemoOptions, QuietSaysNothingButThatItIsUnfinished) {
  EXPECT_THAT(run({"--stops=1"}).said,
              AllOf(HasSubstr("map: "), HasSubstr("free_iou"), HasSubstr("not carried off: ")));
  EXPECT_THAT(run({"--stops=1", "-q"}).said, StartsWith("echomap: error: not finished"));
}

TEST_F(DemoOptions, ARunSaysHowItHasEndedAndWhatToTypeNext) {
  const Ended ended = run({"--stops=1", "--no-kidnap"});
  EXPECT_EQ(ended.status, kUnfinished);
  const auto summary = json("run/summary.json");
  EXPECT_EQ(summary.at("outcome"), "stop-limit");
  EXPECT_EQ(summary.at("finished"), false);
  EXPECT_THAT(summary.at("why"), StartsWith("it came to the limit of its stops; the map has "));
  EXPECT_EQ(summary.at("next"), "echomap demo --world living_room --emulator mock");
  EXPECT_LT(summary.at("coverage").at("share"), 0.9);
  EXPECT_THAT(ended.said,
              HasSubstr(summary.at("why").get<std::string>() +
                        "\n  next: echomap demo --world living_room --emulator mock\n"));
}

TEST_F(DemoOptions, TheNextCommandIsOfTheSameRobotBodyAndDriver) {
  const std::string robot = "--robot=" + path("robot.toml");
  write_text_file(path("robot.toml"), with(profile_text, "\"uno_2wd\"", "\"mine\""));
  write_text_file(path("body.toml"), body_text);
  const Ended ended =
      run({"--stops=1", "--no-kidnap", robot, "--body=" + path("body.toml"), "--driver=tb6612fng"});
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/summary.json").at("next"),
            "echomap demo --world living_room --emulator mock --robot " + path("robot.toml") +
                " --body " + path("body.toml") + " --driver tb6612fng");
}

TEST_F(DemoOptions, TheNextCommandIsByTheSameStrategy) {
  const Ended ended = run({"--stops=1", "--no-kidnap", "--strategy=nxt-farthest"});
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_EQ(json("run/summary.json").at("next"),
            "echomap demo --world living_room --emulator mock --strategy nxt-farthest");
}

TEST_F(DemoOptions, ARobotThatDoesNotFitThroughItsRoomHasNotFinished) {
  const Ended ended = run({"--robot=create", "--world=epuck_field", "--strategy=coastal"});
  EXPECT_EQ(ended.status, kUnfinished);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("robot 'create', 33 cm wide, does not fit through the room"),
                    HasSubstr("next: a larger room: echomap demo --world create_l --emulator mock "
                              "--robot create --strategy coastal\n")));
  EXPECT_EQ(json("run/summary.json").at("finished"), false);
}

TEST_F(DemoOptions, WhatARobotDoesNotGoByIsRefused) {
  const std::vector<std::string> create{"--robot=create", "--strategy=coastal"};
  const Ended by_slam = run({create[0], create[1], "--slam=multiscan"});
  EXPECT_EQ(by_slam.status, 2);
  EXPECT_THAT(by_slam.said, HasSubstr("next: leave out --slam"));
  const Ended by_stops = run({create[0], create[1], "--stops=3"});
  EXPECT_EQ(by_stops.status, 2);
  EXPECT_THAT(by_stops.said, HasSubstr("--stops is for strategy 'nxt-farthest'"));
}

TEST_F(DemoOptions, ARunIsNotOverwrittenUnlessForced) {
  const std::vector<std::string> once{
      "demo", "--emulator=mock", "--stops=1", "--no-kidnap", "--out=" + path("run")};
  EXPECT_EQ(Program("echomap", once, path("log")).wait().status, kUnfinished);
  const std::string summary = read_text_file(scratch / "run/summary.json");
  const Ended again = Program("echomap", once, path("log")).wait();
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.said, AllOf(HasSubstr("has a run in it"), HasSubstr("--force")));
  EXPECT_EQ(read_text_file(scratch / "run/summary.json"), summary);
}

TEST_F(DemoOptions, WhatCannotBeWrittenIsSaidBeforeTheRobotMoves) {
  write_text_file(path("file"), "");
  const Ended out =
      Program("echomap", {"demo", "--emulator=mock", "--out=" + path("file/run")}, path("log"))
          .wait();
  EXPECT_EQ(out.status, 1);
  EXPECT_THAT(out.said, AllOf(HasSubstr(path("file/run")), HasSubstr("next: ")));

  const Ended json = run({"--json=" + path("no_folder/report.json")});
  EXPECT_EQ(json.status, 1);
  EXPECT_THAT(json.said, HasSubstr(path("no_folder/report.json")));
  EXPECT_THAT(run({"--json=" + path("")}).said, HasSubstr("it is a directory"));
  EXPECT_FALSE(fs::exists(scratch / "run/truth"));
  EXPECT_TRUE(fs::is_empty(scratch / "run"));
}

TEST_F(DemoOptions, ARunWithoutItsTruthIsReportedAndFails) {
  Program program("echomap",
                  demo({"--world=empty_room", "--no-kidnap", "--json=" + path("report.json")}),
                  scratch / "log");
  ASSERT_TRUE(eventually([&] { return fs::exists(scratch / "run/summary.json"); }));
  fs::remove_all(scratch / "run/truth");
  write_text_file(scratch / "run/truth", "in the way");
  const Ended ended = program.wait();
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("the map has no score"), HasSubstr("robot.log")));
  EXPECT_GT(json("report.json").at("stops"), 1);
  EXPECT_FALSE(json("report.json").contains("free_iou"));
}

}  // namespace
}  // namespace echomap::test
