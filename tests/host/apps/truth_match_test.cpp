// SPDX-License-Identifier: MIT
#include "host/apps/truth_match.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::apps {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class TruthMatch : public testing::Test {
 protected:
  TruthMatch() {
    std::filesystem::create_directories(run_);
    std::filesystem::create_directories(truth_);
  }
  void name_worlds(const std::string& driven, const std::string& true_world) const {
    files::write_text_file(run_ / "summary.json", R"({"world": ")" + driven + R"("})");
    files::write_text_file(truth_ / "truth.json", R"({"world": ")" + true_world + R"("})");
  }
  std::string complaint() const {
    return tests::thrown_text<console::CommandError>([&] { match_rooms(run_, truth_); });
  }

  const tests::ScratchFolder scratch_;
  const std::filesystem::path run_ = scratch_ / "run";
  const std::filesystem::path truth_ = scratch_ / "elsewhere";
};

TEST_F(TruthMatch, TakesOneRoomAndNamesTwo) {
  name_worlds("nxt_room", "nxt_room");
  EXPECT_EQ(match_rooms(run_, truth_), RoomMatch::kSame);
  name_worlds("living_room", "create_l");
  EXPECT_THAT(complaint(), HasSubstr("is a run in the room 'living_room', and"));
  EXPECT_THAT(complaint(), HasSubstr("next: name the truth of the same run with --truth"));
  std::filesystem::create_directories(run_ / "truth");
  EXPECT_THAT(
      complaint(),
      EndsWith("next: echomap eval " + run_.string() + " --truth " + (run_ / "truth").string()));
}

TEST_F(TruthMatch, DoesNotKnowWhereOneNamesNoRoomOrAFile) {
  EXPECT_EQ(match_rooms(run_, truth_), RoomMatch::kUnknown) << "no reports";
  name_worlds("", "create_l");
  EXPECT_EQ(match_rooms(run_, truth_), RoomMatch::kUnknown) << "a robot at a port";
  name_worlds("rooms/mine.toml", "mine");
  EXPECT_EQ(match_rooms(run_, truth_), RoomMatch::kUnknown);
}

TEST_F(TruthMatch, JudgesByTheWallsWhereItDoesNotKnow) {
  evaluation::RunScore score;
  EXPECT_NO_THROW(refuse_misfit(run_, truth_, score)) << "a map without walls";
  score.start.map = {0.36, 0.26, 0.10};
  score.fitted.map = {0.34, 0.40, 0.07};
  EXPECT_THAT(
      tests::thrown_text<console::CommandError>([&] { refuse_misfit(run_, truth_, score); }),
      HasSubstr("its walls are off by 26 cm or more, and it has 10 % of the true walls"));
  score.start.map = {0.69, 0.54, 0.52};
  EXPECT_NO_THROW(refuse_misfit(run_, truth_, score)) << "bent by a robot that was carried off";
  score.start.map = {0.05, 0.04, 0.07};
  EXPECT_NO_THROW(refuse_misfit(run_, truth_, score)) << "one stop in a large room";
}

}  // namespace
}  // namespace echomap::apps
