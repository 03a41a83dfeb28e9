// SPDX-License-Identifier: MIT
#include "host/session/line_recorder.hpp"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/recording/session_reader.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

using Bytes = std::vector<std::uint8_t>;

class LineRecorderTest : public ::testing::Test {
 protected:
  /// Hands on, and takes pieces that end with `used` for observations.
  void receive(const Bytes& bytes) {
    line.receive(bytes, [this](std::span<const std::uint8_t> piece) {
      pieces.emplace_back(piece.begin(), piece.end());
      if (piece.size() > 1 && piece.back() == 0 && piece[piece.size() - 2] == 9) {
        line.use(1234);
      }
    });
  }
  std::vector<recording::RecordedFrame> recorded() {
    session.open(scratch / "session.mcap");
    session.finish();
    std::vector<recording::RecordedFrame> frames;
    recording::SessionReader reader(scratch / "session.mcap");
    for (auto entry = reader.next(); entry; entry = reader.next()) {
      frames.push_back(std::get<recording::RecordedFrame>(*entry));
    }
    return frames;
  }

  const tests::ScratchFolder scratch;
  recording::SessionRecorder session{{}};
  LineRecorder line{&session};
  std::vector<Bytes> pieces;
};

TEST_F(LineRecorderTest, RecordsFramesWhole) {
  receive({1, 2, 9});
  receive({0, 3, 0, 4});
  EXPECT_EQ(pieces, (std::vector<Bytes>{{1, 2, 9}, {0}, {3, 0}, {4}})) << "nothing waits";
  const auto frames = recorded();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].frame.data, (Bytes{1, 2, 9, 0}));
  EXPECT_EQ(frames[1].frame.data, (Bytes{3, 0}));
}

TEST_F(LineRecorderTest, RecordsEncoderErrorsOnlyOfABoardThatSeesThem) {
  robot_link::LinkStatistics link;
  link.robot_encoder_errors = std::nullopt;
  line.record(link);
  link.robot_encoder_errors = 5;
  line.record(link);
  session.open(scratch / "session.mcap");
  session.finish();
  std::vector<std::string> told;
  for (const mcap::Message& message : tests::all_messages(scratch / "session.mcap")) {
    if (message.channel->info.topic != "/diagnostics") {
      continue;
    }
    const auto all = ros_messages::deserialize<ros_messages::DiagnosticArray>(message.data);
    std::string errors = "unknown";
    for (const auto& one : all.status.at(0).values) {
      errors = one.key == "robot encoder errors" ? one.value : errors;
    }
    told.push_back(errors);
  }
  EXPECT_EQ(told, (std::vector<std::string>{"unknown", "5"}));
}

TEST_F(LineRecorderTest, KnowsWhichFrameWasAnObservation) {
  receive({1, 9, 0, 2, 8, 0});
  const auto frames = recorded();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_TRUE(frames[0].frame.is_used);
  EXPECT_EQ(frames[0].frame.robot_stamp_us, 1234U);
  EXPECT_FALSE(frames[1].frame.is_used);
}

TEST_F(LineRecorderTest, RecordsBytesThatAreNoFrame) {
  receive(Bytes(300, 7));
  const auto frames = recorded();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].frame.data.size(), 300U);
}

TEST_F(LineRecorderTest, SplitsWhatIsSentAndLeavesOutLoneDelimiters) {
  line.sent(Bytes{0, 0, 5, 6, 0, 7, 0});
  const auto frames = recorded();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_TRUE(frames[0].is_sent);
  EXPECT_EQ(frames[0].frame.data, (Bytes{5, 6, 0}));
}

TEST_F(LineRecorderTest, WithoutARecorderOnlyHandsOn) {
  LineRecorder none(nullptr);
  none.set_time({});
  none.sent(Bytes{1, 0});
  none.record(recording::SessionEvent{});
  none.record(robot_link::LinkStatistics{});
  std::size_t bytes = 0;
  none.receive(Bytes{1, 0, 2}, [&](std::span<const std::uint8_t> piece) { bytes += piece.size(); });
  EXPECT_EQ(bytes, 3U);
}

}  // namespace
}  // namespace echomap::session
