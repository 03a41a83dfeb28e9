// SPDX-License-Identifier: MIT
#include "host/recording/session_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/recording/session_recorder.hpp"
#include "host/ros_messages/std_msgs.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::recording {
namespace {

using ::testing::HasSubstr;

class SessionReaderTest : public ::testing::Test {
 protected:
  SessionReaderTest() {
    recorder.describe("robot.toml", "name = 'x'");
    recorder.describe("session", {{"slam", "ekf"}});
    recorder.begin_session(0);
  }
  void save(std::uint64_t split_bytes = 0) {
    recorder.open(path, split_bytes);
    recorder.attach("summary.json", "application/json", "{}");
    recorder.finish();
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path path = scratch / "session.mcap";
  SessionRecorder recorder{{}};
};

TEST_F(SessionReaderTest, GivesFramesAndEventsInTheirOrder) {
  const std::vector<std::uint8_t> bytes{1, 2, 0};
  recorder.set_time(time::HostTime(std::chrono::milliseconds(20)));
  recorder.add_sent(bytes);
  recorder.add_received(bytes, 77);
  recorder.add_event({SessionEventKind::kPoseFix, 5, {1.0, 2.0, 0.1}});
  recorder.add_received(bytes, std::nullopt);
  save();
  SessionReader reader(path);
  EXPECT_EQ(reader.fact("session", "slam"), "ekf");
  EXPECT_EQ(reader.attachment("robot.toml"), "name = 'x'");
  EXPECT_EQ(std::get<SessionEvent>(reader.next().value()).kind, SessionEventKind::kBeginSession);
  EXPECT_TRUE(std::get<RecordedFrame>(reader.next().value()).is_sent);
  const auto used = std::get<RecordedFrame>(reader.next().value());
  EXPECT_EQ(used.frame.data, bytes);
  EXPECT_EQ(used.frame.robot_stamp_us, 77U);
  EXPECT_TRUE(used.frame.is_used);
  EXPECT_DOUBLE_EQ(reader.elapsed_s(), 0.02);
  const auto fix = std::get<SessionEvent>(reader.next().value());
  EXPECT_EQ(fix.value, 5);
  EXPECT_EQ(fix.T_map_robot.heading_rad(), 0.1) << "to the bit";
  EXPECT_FALSE(std::get<RecordedFrame>(reader.next().value()).frame.is_used);
  EXPECT_FALSE(reader.attachment("summary.json"));
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.attachment("summary.json"), "{}");
  EXPECT_FALSE(reader.attachment("none"));
  EXPECT_EQ(reader.fact("session", "none"), "");
}

TEST_F(SessionReaderTest, LeavesPausesBetweenSessionsOutOfItsSeconds) {
  recorder.set_time(time::HostTime(std::chrono::seconds(10)));
  recorder.add_sent(std::vector<std::uint8_t>{1, 0});
  recorder.begin_session(86'400'000'000'000);
  recorder.set_time(time::HostTime(std::chrono::seconds(5)));
  recorder.add_sent(std::vector<std::uint8_t>{1, 0});
  save();
  SessionReader reader(path);
  while (reader.next()) {
  }
  EXPECT_EQ(reader.time_ns(), 86'405'000'000'000U);
  EXPECT_DOUBLE_EQ(reader.elapsed_s(), 15.0);
}

TEST_F(SessionReaderTest, ReadsAllParts) {
  for (int i = 0; i < 30000; ++i) {
    recorder.set_time(time::HostTime(std::chrono::milliseconds(10 * i)));
    recorder.add_event({SessionEventKind::kLinkReady, i * 7919 % 10007});
    if (i == 0) {
      recorder.open(path, 20000);
    }
  }
  recorder.finish();
  ASSERT_TRUE(exists(part_of(path, 1)));
  SessionReader reader(path);
  EXPECT_EQ(std::get<SessionEvent>(reader.next().value()).kind, SessionEventKind::kBeginSession);
  for (int i = 0; i < 30000; ++i) {
    ASSERT_EQ(std::get<SessionEvent>(reader.next().value()).value, i * 7919 % 10007);
  }
  EXPECT_FALSE(reader.next());
}

TEST_F(SessionReaderTest, TakesNoFileOfAnotherSessionForItsNextPart) {
  recorder.add_event({SessionEventKind::kLinkReady});
  save();
  SessionRecorder other({});
  other.describe("session", {{"slam", "multiscan"}});
  other.begin_session(0);
  other.open(part_of(path, 1));
  other.finish();
  SessionReader reader(path);
  int entries = 0;
  while (reader.next()) {
    ++entries;
  }
  EXPECT_EQ(entries, 2);
}

TEST_F(SessionReaderTest, KeepsWhatIsWrongWithItsHead) {
  save();
  std::string bytes = files::read_text_file(path);
  const std::size_t place = bytes.find("name = 'x'");
  ASSERT_NE(place, std::string::npos);
  bytes[place] = 'm';
  files::write_text_file(path, bytes);
  SessionReader reader(path);
  EXPECT_THAT(reader.head_damage(), HasSubstr("byte "));
  EXPECT_THROW(reader.next(), files::FileError);
}

TEST_F(SessionReaderTest, ReadsTheEndingBehindADamageToo) {
  save();
  SessionReader reader(path);
  reader.read_ending();
  EXPECT_EQ(reader.attachment("summary.json"), "{}");
}

TEST_F(SessionReaderTest, KnowsAFileOfOthers) {
  mcap::McapWriter writer({"ros2", "somebody"});
  writer.open(path);
  writer.finish();
  EXPECT_FALSE(is_session_file(path));
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { SessionReader reader(path); }),
              HasSubstr("not the recording of a session of echomap, but of 'somebody'"));
  EXPECT_FALSE(is_session_file(scratch / "map.yaml"));
}

TEST_F(SessionReaderTest, NamesAMessageThatIsDamaged) {
  SessionFile file;
  file.write(kEventTopic, 0, SessionEventMessage{"begin-scans", 0, {}});
  file.open(path);
  file.finish();
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { SessionReader(path).next(); }),
              HasSubstr("'begin-scans' is no event of a session"));
  SessionFile other;
  other.write(kEventTopic, 0, ros_messages::String{"?"});
  other.open(path);
  other.finish();
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { SessionReader(path).next(); }),
              HasSubstr("a message of /session/events at 0"));
}

}  // namespace
}  // namespace echomap::recording
