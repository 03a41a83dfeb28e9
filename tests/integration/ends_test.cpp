// SPDX-License-Identifier: MIT
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

/// A robot without cliff sensors lies on its belly there, and its wheels turn.
constexpr const char* kHoleInTheFloor = R"(name = "hole_in_the_floor"
[start]
x_m = 0.5
y_m = 0.8
heading_deg = 0.0
[room]
corners_m = [[0.0, 0.0], [2.4, 0.0], [2.4, 1.6], [0.0, 1.6]]
[[hole]]
name = "all across"
corners_m = [[0.9, 0.0], [1.2, 0.0], [1.2, 1.6], [0.9, 1.6]]
)";

/// A run that ends so, by the demo on the native mock.
struct End {
  const char* name;
  std::vector<std::string> options;
  int status;
  const char* outcome;
  /// The closing paragraph. RUN stands for the run directory, WORLD for the file of `world`, N for
  /// a number, PORT for the port.
  const char* said;
  /// Of a room that is not bundled: the content of its file.
  const char* world = nullptr;
};

/// From its middle, every wall is out of the sonar's range.
constexpr const char* kLargeEmptyHall = R"(name = "large_empty_hall"
[start]
x_m = 6.0
y_m = 6.0
heading_deg = 20.0
[room]
corners_m = [[0.0, 0.0], [12.0, 0.0], [12.0, 12.0], [0.0, 12.0]]
)";

/// Two rooms and a gap of 0.22 m between them, for a robot of 0.18 m that keeps 4 cm off walls. The
/// cone of the sonar is wider than the gap: its sides answer, and nobody knows of the other room.
constexpr const char* kNarrowGap = R"(name = "narrow_gap"
[start]
x_m = 0.6
y_m = 0.8
heading_deg = 0.0
[room]
corners_m = [[0.0, 0.0], [3.2, 0.0], [3.2, 1.6], [0.0, 1.6]]
[[obstacle]]
name = "one side of the gap"
corners_m = [[1.60, 0.00], [1.70, 0.00], [1.70, 0.69], [1.60, 0.69]]
[[obstacle]]
name = "the other side"
corners_m = [[1.60, 0.91], [1.70, 0.91], [1.70, 1.60], [1.60, 1.60]]
)";

std::vector<End> ends() {
  return {
      {"Finished",
       {"--world=nxt_room"},
       0,
       "complete",
       "finished: the map has N % of the floor that the robot can reach, N m², walls off by about "
       "N cm (N in N such maps: by less than N cm)\n"
       "  next: echomap eval RUN --truth RUN/truth --picture RUN/score.png\n"},
      {"StopLimit",
       {"--world=nxt_room", "--stops=1"},
       kUnfinished,
       "stop-limit",
       "echomap: error: not finished; the map so far is saved: it came to the limit of its stops; "
       "the map has N % of the floor that the robot can reach, N m²; most of what is unseen is "
       "near "
       "(N, N)\n  next: echomap demo --world nxt_room --emulator mock\n"},
      {"SonarDead",
       {"--part-faults=sonar-dead@60"},
       1,
       "sonar-silent",
       "echomap: error: not finished; the map so far is saved: the sonar does not answer: it is "
       "not connected, or it is dead\n"
       "  next: check the sonar's wiring and its supply, then start again\n"},
      {"SonarDeadFromTheStart",
       {"--part-faults=sonar-dead@0"},
       1,
       "sonar-silent",
       "echomap: error: not finished; the map so far is saved: the sonar does not answer: it is "
       "not connected, or it is dead\n"
       "  next: check the sonar's wiring and its supply, then start again\n"},
      {"LargeEmptyHall",
       {"--stops=12"},
       kUnfinished,
       "stop-limit",
       "echomap: error: not finished; the map so far is saved: it came to the limit of its stops; "
       "the map has N % of the floor that the robot can reach, N m², walls off by about N cm (N in "
       "N such maps: by less than N cm); most of what is unseen is near "
       "(N, N)\n  next: echomap demo --world WORLD --emulator mock\n",
       kLargeEmptyHall},
      {"TooNarrow",
       {},
       0,
       "complete",
       "finished: the map has N % of the floor that the robot can reach, N m², walls off by about "
       "N cm (N in N such maps: by less than N cm)\n"
       "  next: echomap eval RUN --truth RUN/truth --picture RUN/score.png\n",
       kNarrowGap},
      {"Stuck",
       {},
       9,
       "robot-fault",
       "echomap: error: not finished; the map so far is saved: the wheels turn and the robot stays "
       "where it is\n"
       "  next: free it, put it on the floor and see whether its wheels grip, then: echomap demo "
       "--world WORLD --emulator mock\n",
       kHoleInTheFloor},
      {"Cable",
       {"--faults=away=60:1000"},
       5,
       "link-lost",
       "echomap: error: not finished; the map so far is saved: lost PORT: the robot stopped "
       "sending\n"
       "  next: check its cable and its supply, then start again; --reconnect N waits longer\n"},
      {"Battery",
       {"--robot=create", "--world=create_l", "--strategy=coastal", "--part-faults=battery-low@20"},
       7,
       "battery-low",
       "echomap: error: not finished; the map so far is saved: the battery is low\n"
       "  next: charge it without moving the robot, then: echomap demo --world create_l --emulator "
       "mock\n"},
      {"Lost",
       {"--robot=ev3",
        "--world=playground",
        "--strategy=tangent-bug",
        "--waypoints=playground",
        "--part-faults=slip-left@60:8:0.6"},
       1,
       "lost",
       "echomap: error: not finished; the map so far is saved: sonar readings contradict the map: "
       "the robot was carried, or its wheels slipped\n"
       "  next: start again, or find it in its map: echomap localize --map RUN\n"},
  };
}

class EndOfARun : public ::testing::Test {
 protected:
  /// What was said from the closing paragraph on, without what differs from run to run.
  std::string closing_paragraph(const std::string& said) const {
    const std::size_t begin = std::min(said.find("finished: the map"), said.find("echomap: error"));
    std::string text = begin == std::string::npos ? said : said.substr(begin);
    for (const auto& [path, word] : {std::pair(run_, "RUN"),
                                     std::pair(world_, "WORLD"),
                                     std::pair(port_, "PORT"),
                                     std::pair(lockstep_, "LOCKSTEP")}) {
      for (std::size_t at = 0; (at = text.find(path.string(), at)) != std::string::npos;) {
        text.replace(at, path.string().size(), word);
      }
    }
    text = std::regex_replace(text, std::regex("lost /[^:]*:"), "lost PORT:");
    return std::regex_replace(text, std::regex("-?[0-9]+(\\.[0-9]+)?"), "N");
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(run_ / "summary.json"));
  }
  /// The run directory says what stderr says.
  void expect_summary_of(const Ended& ended, const std::string& outcome) const {
    const auto told = summary();
    EXPECT_EQ(told.at("outcome"), outcome);
    EXPECT_EQ(told.at("finished"), ended.status == 0);
    EXPECT_THAT(ended.said, ::testing::HasSubstr(told.at("why").get<std::string>()));
    EXPECT_THAT(ended.said,
                ::testing::HasSubstr("\n  next: " + told.at("next").get<std::string>() + "\n"));
  }

  const tests::ScratchFolder scratch_;
  const std::filesystem::path run_ = scratch_ / "run";
  const std::filesystem::path world_ = scratch_ / "world.toml";
  const std::filesystem::path port_ = scratch_ / "robot";
  const std::filesystem::path lockstep_ = scratch_ / "grants";
};

class Ends : public EndOfARun, public ::testing::WithParamInterface<End> {};

TEST_P(Ends, SayHowItWentAndWhatToDoNext) {
  std::vector<std::string> arguments{
      "demo", "--emulator=mock", "--headless", "--no-kidnap", "--out=" + run_.string()};
  arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
  if (GetParam().world != nullptr) {
    files::write_text_file(world_, GetParam().world);
    arguments.push_back("--world=" + world_.string());
  }
  const Ended ended = Program("echomap", arguments, scratch_ / "log").wait();
  EXPECT_EQ(ended.status, GetParam().status);
  EXPECT_EQ(closing_paragraph(ended.said), GetParam().said) << ended.said;
  expect_summary_of(ended, GetParam().outcome);
}

INSTANTIATE_TEST_SUITE_P(Staged,
                         Ends,
                         ::testing::ValuesIn(ends()),
                         [](const ::testing::TestParamInfo<End>& end) { return end.param.name; });

/// At the port of a mock, as at that of a real robot.
class EndAtAPort : public EndOfARun {
 protected:
  /// In a room, until the host has gone.
  Program start_robot(std::vector<std::string> more) const {
    more.insert(more.end(), {"--link=" + port_.string(), "--lockstep=" + lockstep_.string()});
    return {"echomap-mock", std::move(more), scratch_ / "robot_log"};
  }
  void await_robot() const {
    EXPECT_TRUE(eventually([&] { return exists(lockstep_) && exists(port_); }));
  }
  std::vector<std::string> explore(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"explore",
                                       "--headless",
                                       "--port=" + port_.string(),
                                       "--lockstep=" + lockstep_.string(),
                                       "--out=" + run_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// A bundled file of the robot uno_2wd with a wheel-drop switch at its first spare pin.
  std::filesystem::path with_wheel_drop(const std::string& folder, const std::string& wiring) {
    const auto path = scratch_ / (wiring + ".toml");
    files::write_text_file(
        path,
        files::read_text_file(files::bundled_file("uno_2wd", folder, "a robot")) + "\n[" + wiring +
            "]\npin_0 = \"wheel_drop\"\n");
    return path;
  }
};

TEST_F(EndAtAPort, OfARobotThatIsLiftedAndNotPutDown) {
  Program robot =
      start_robot({"--world=nxt_room",
                   "--kidnap=30,100000,1,1,0",
                   "--robot=" + with_wheel_drop("hil_mock/robots", "wiring.native").string()});
  await_robot();
  const Ended ended =
      Program("echomap",
              explore({"--robot=" + with_wheel_drop("host/profiles", "wiring").string()}),
              scratch_ / "log")
          .wait();
  EXPECT_EQ(ended.status, 7);
  EXPECT_EQ(closing_paragraph(ended.said),
            "echomap: error: not finished; the map so far is saved: the robot was lifted and not "
            "put down within N minutes\n"
            "  next: put it down and start again\n")
      << ended.said;
  expect_summary_of(ended, "safety-stop");
  EXPECT_GT(summary().at("free_area_m2"), 0.5) << "what it mapped before";
}

TEST_F(EndAtAPort, OfARunThatIsInterrupted) {
  Program robot = start_robot({"--world=living_room"});
  await_robot();
  Program host("echomap", explore({}), scratch_ / "log");
  EXPECT_TRUE(eventually([&] { return exists(run_ / "summary.json"); }));
  host.send(SIGINT);
  const Ended ended = host.wait();
  EXPECT_EQ(ended.status, 130);
  EXPECT_EQ(closing_paragraph(ended.said),
            "echomap: error: not finished; the map so far is saved: interrupted\n"
            "  next: echomap explore --port PORT --resume RUN --out RUN\n")
      << ended.said;
  expect_summary_of(ended, "interrupted");
  EXPECT_GT(summary().at("free_area_m2"), 0.5);
  EXPECT_TRUE(exists(run_ / "map.png"));
}

/// The record of the first stop is larger than what fits.
TEST_F(EndAtAPort, OfARunThatDoesNotFitOnItsDisk) {
  Program robot = start_robot({"--world=nxt_room"});
  await_robot();
  const Ended ended = Program("echomap", explore({"--stops=2"}), scratch_ / "log", 32).wait();
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(closing_paragraph(ended.said),
            "echomap: error: the run is not saved, or only up to an earlier stop: cannot write "
            "RUN/observations.csv: File too large\n"
            "  next: make room there, or name another directory with --out; then start again\n")
      << ended.said;
  EXPECT_TRUE(std::filesystem::is_empty(run_)) << "nothing that is cut off";
}

/// What was saved at the first stop does not say that it is the whole run.
TEST_F(EndAtAPort, OfARunWhoseDiskBecomesFull) {
  Program robot = start_robot({"--world=nxt_room"});
  await_robot();
  const Ended ended = Program("echomap", explore({"--stops=4"}), scratch_ / "log", 200).wait();
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(closing_paragraph(ended.said),
              ::testing::HasSubstr("the run is not saved, or only up to an earlier stop"));
  EXPECT_EQ(summary().at("outcome"), "exploring");
  EXPECT_EQ(summary().at("finished"), false);
  EXPECT_LT(summary().at("stops"), 4);
}

}  // namespace
}  // namespace echomap::test
