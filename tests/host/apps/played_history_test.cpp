// SPDX-License-Identifier: MIT
#include "host/apps/played_history.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/apps/recorded_run.hpp"
#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "tests/host/live_page/read_messages.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/written_recording.hpp"

namespace echomap::apps {
namespace {

using live_page::MessageKind;
using live_page::SharedMessage;
using testing::HasSubstr;

class PlayedHistoryTest : public testing::Test {
 protected:
  PlayedHistoryTest() {
    std::filesystem::create_directories(run);
    recording.recorder().describe("session",
                                  {{"robot", profile.name},
                                   {"slam", "multiscan"},
                                   {"command", "explore"},
                                   {"version", "0.0.9"}});
    recording.begin(recorded);
  }
  void end_recording() {
    recording.recorder().describe_ending({{"finished", "true"},
                                          {"outcome", "complete"},
                                          {"why", "all is seen"},
                                          {"next", "echomap eval first_map"}});
    recording.recorder().finish();
  }
  /// All messages that a page gets of the run.
  std::vector<SharedMessage> messages() const { return played_run(run, "3").history->since(0); }
  std::vector<SharedMessage> messages(MessageKind kind) const {
    return live_page::of_kind(*played_run(run, "3").history, kind);
  }
  nlohmann::json last_state() const {
    const auto states = messages(MessageKind::kState);
    return states.empty() ? nlohmann::json() : json_in(*states.back());
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path run = scratch / "first_map";
  const std::filesystem::path recorded = run / recording::kSessionFileName;
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  tests::WrittenRecording recording{profile};
};

TEST_F(PlayedHistoryTest, BeginsWithWhatTheRunWas) {
  recording.add_stop(1.0);
  end_recording();
  const auto all = messages();
  ASSERT_FALSE(all.empty());
  ASSERT_EQ(all.front()->kind, MessageKind::kHello);
  const nlohmann::json hello = json_in(*all.front());
  EXPECT_EQ(hello.at("name"), "first_map");
  EXPECT_EQ(hello.at("run"), "3");
  EXPECT_EQ(hello.at("version"), "0.0.9") << "of the program that drove";
  EXPECT_EQ(hello.at("command"), "explore");
  EXPECT_EQ(hello.at("robot"), "uno_2wd");
  EXPECT_EQ(hello.at("live"), false);
  EXPECT_EQ(hello.at("can"), nlohmann::json::array());
}

TEST_F(PlayedHistoryTest, HasTheMapAsItGrewAndMotionsBetweenInTheOrderOfTime) {
  recording.add_stop(1.0);
  recording.add_stop(1.2);
  end_recording();
  EXPECT_GE(messages(MessageKind::kTile).size(), 2U);
  EXPECT_EQ(messages(MessageKind::kTrail).size(), 2U);
  EXPECT_EQ(messages(MessageKind::kRoom).size(), 2U);
  const auto motions = messages(MessageKind::kMotion);
  EXPECT_THAT(motions.size(), testing::AllOf(testing::Ge(3U), testing::Le(4U)))
      << "ten a second, of 0.32 s";
  const auto all = messages();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& one, const auto& other) {
    return one->time_s < other->time_s;
  }));
  EXPECT_NEAR(all.back()->time_s, 0.32, 1e-9);
}

TEST_F(PlayedHistoryTest, TellsThePingsOfTheSonar) {
  recording.add_stop(1.0);
  end_recording();
  const auto motions = messages(MessageKind::kMotion);
  ASSERT_FALSE(motions.empty());
  const std::string body = body_of(*motions.back());
  EXPECT_GT(live_page::u32_at(body, 68), 0U);
  EXPECT_EQ(live_page::u32_at(body, 72), 1U);
  EXPECT_GE(live_page::f32_at(body, 64), 0.9F);
}

TEST_F(PlayedHistoryTest, EndsWithWhatTheRunHasComeTo) {
  recording.add_stop(1.0);
  recording.add_stop(1.2);
  end_recording();
  const nlohmann::json state = last_state();
  EXPECT_EQ(state.at("mode"), "recording");
  EXPECT_EQ(state.at("stops"), 2);
  EXPECT_GT(state.at("floor_m2").get<double>(), 0.0);
  EXPECT_FALSE(state.at("coverage").is_null());
  EXPECT_TRUE(state.at("left_s").is_null()) << "nothing is left of a run that has ended";
  EXPECT_EQ(state.at("result"), nlohmann::json::parse(R"({"finished": true, "outcome": "complete",
                "why": "all is seen", "next": "echomap eval first_map"})"));
}

TEST_F(PlayedHistoryTest, BeginsANewMapWhereTheRunDid) {
  for (const double range_m : {1.0, 1.2, 1.0, 1.1}) {
    recording.add_stop(range_m);
  }
  recording.add(recording::SessionEventKind::kBeginNewMap, 2);
  recording.add_stop(1.0);
  end_recording();
  EXPECT_EQ(messages(MessageKind::kNewMap).size(), 1U);
}

TEST_F(PlayedHistoryTest, OfARunThatWasCutOffSaysSo) {
  recording.add_stop(1.0);
  recording.save(scratch / "unused");
  const std::string bytes = files::read_text_file(recorded);
  files::write_text_file(recorded, bytes.substr(0, bytes.find("ending")));
  EXPECT_EQ(last_state().at("result").at("outcome"), "cut-off");
  EXPECT_EQ(last_state().at("result").at("finished"), false);
  EXPECT_EQ(last_state().at("stops"), 1);
}

TEST_F(PlayedHistoryTest, IsNamedByItsFolder) {
  recording.add_stop(1.0);
  end_recording();
  const live_page::ServedRun of_folder = played_run(run, "0");
  EXPECT_EQ(of_folder.name, "first_map");
  EXPECT_EQ(of_folder.folder, run);
  EXPECT_FALSE(of_folder.live);
  EXPECT_EQ(played_run(run / "", "0").name, "first_map") << "with a slash behind it";
  const live_page::ServedRun of_file = played_run(recorded, "0");
  EXPECT_EQ(of_file.name, "first_map");
  EXPECT_EQ(of_file.folder, "") << "what lies beside a file that is named is not asked for";
}

TEST_F(PlayedHistoryTest, NeedsARecording) {
  EXPECT_THAT(
      tests::thrown_text<files::FileError>([&] { played_run(scratch.path(), "0"); }),
      HasSubstr("neither a run directory with a recording nor a session.mcap\n  next: name a run"));
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { played_run(scratch / "none", "0"); }),
              HasSubstr("none: neither"));
}

TEST_F(PlayedHistoryTest, OfARunThatOnlyLocalizedIsAnError) {
  tests::WrittenRecording localized(profile);
  localized.recorder().describe("session", {{"command", kLocalizeCommand}});
  localized.add_stop(1.0);
  const std::filesystem::path file = scratch / "localized.mcap";
  localized.save(file);
  EXPECT_THAT(tests::thrown_text<console::CommandError>([&] { played_run(file, "0"); }),
              HasSubstr("is of a run that localized, and has no map\n  next: "));
}

}  // namespace
}  // namespace echomap::apps
