// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <regex>
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

/// A run that ends so, by the demo on the native mock.
struct End {
  const char* name;
  std::vector<std::string> options;
  int status;
  const char* outcome;
  /// The closing paragraph. RUN stands for the run directory, N for a number, PORT for the port.
  const char* said;
};

std::vector<End> ends() {
  return {
      {"Finished",
       {"--world=nxt_room"},
       0,
       "complete",
       "finished: the map has N % of the floor that the robot can reach, N m²\n"
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

class Ends : public ::testing::TestWithParam<End> {
 protected:
  /// What was said from the closing paragraph on, without what differs from run to run.
  std::string closing_paragraph(const std::string& said) const {
    const std::size_t begin = std::min(said.find("finished: the map"), said.find("echomap: error"));
    std::string text = begin == std::string::npos ? said : said.substr(begin);
    for (std::size_t at = 0; (at = text.find(run_.string(), at)) != std::string::npos;) {
      text.replace(at, run_.string().size(), "RUN");
    }
    text = std::regex_replace(text, std::regex("lost /[^:]*:"), "lost PORT:");
    return std::regex_replace(text, std::regex("-?[0-9]+(\\.[0-9]+)?"), "N");
  }

  const tests::ScratchFolder scratch_;
  const std::filesystem::path run_ = scratch_ / "run";
};

TEST_P(Ends, SayHowItWentAndWhatToDoNext) {
  std::vector<std::string> arguments{
      "demo", "--emulator=mock", "--headless", "--no-kidnap", "--out=" + run_.string()};
  arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
  const Ended ended = Program("echomap", arguments, scratch_ / "log").wait();
  EXPECT_EQ(ended.status, GetParam().status);
  EXPECT_EQ(closing_paragraph(ended.said), GetParam().said) << ended.said;
  const auto summary = nlohmann::json::parse(files::read_text_file(run_ / "summary.json"));
  EXPECT_EQ(summary.at("outcome"), GetParam().outcome);
  EXPECT_EQ(summary.at("finished"), GetParam().status == 0);
  EXPECT_THAT(ended.said, ::testing::HasSubstr(summary.at("why").get<std::string>()));
  EXPECT_THAT(ended.said,
              ::testing::HasSubstr("\n  next: " + summary.at("next").get<std::string>() + "\n"));
}

INSTANTIATE_TEST_SUITE_P(Staged,
                         Ends,
                         ::testing::ValuesIn(ends()),
                         [](const ::testing::TestParamInfo<End>& end) { return end.param.name; });

}  // namespace
}  // namespace echomap::test
