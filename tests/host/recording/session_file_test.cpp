// SPDX-License-Identifier: MIT
#include "host/recording/session_file.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/ros_messages/std_msgs.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/mcap_records.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::recording {
namespace {

class SessionFileTest : public ::testing::Test {
 protected:
  static void write(SessionFile& file, int messages) {
    for (int i = 0; i < messages; ++i) {
      file.write("/text", static_cast<std::uint64_t>(i), ros_messages::String{std::to_string(i)});
    }
  }
  /// The texts of a file, and what stands beside them.
  std::vector<std::string> read(const std::filesystem::path& file) {
    std::vector<std::string> read;
    for (const mcap::Record& record : tests::all_records(file)) {
      if (const auto* message = std::get_if<mcap::Message>(&record)) {
        read.push_back(ros_messages::deserialize<ros_messages::String>(message->data).data);
      } else if (const auto* metadata = std::get_if<mcap::Metadata>(&record)) {
        read.push_back("metadata " + metadata->name);
      } else {
        read.push_back("attachment " + std::get<mcap::Attachment>(record).name);
      }
    }
    return read;
  }

  /// The texts of all parts.
  std::vector<std::string> all_texts() {
    std::vector<std::string> texts;
    for (std::size_t part = 0; exists(part_of(path, part)); ++part) {
      const auto some = read(part_of(path, part));
      std::copy_if(
          some.begin(), some.end(), std::back_inserter(texts), [](const std::string& text) {
            return !text.starts_with("metadata") && !text.starts_with("attachment");
          });
    }
    return texts;
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path path = scratch / "session.mcap";
};

/// What it hears, in words.
class HeardTopics final : public TopicListener {
 public:
  void on_topic(const RecordedTopic& topic) override {
    heard.push_back(std::to_string(topic.id) + " is " + topic.name + ", " + topic.schema_name +
                    ", " + topic.schema_text);
  }
  void on_message(std::uint32_t topic,
                  std::uint64_t log_time_ns,
                  std::span<const std::uint8_t> bytes) override {
    heard.push_back(std::to_string(topic) + " at " + std::to_string(log_time_ns) + ": " +
                    ros_messages::deserialize<ros_messages::String>(bytes).data);
  }

  std::vector<std::string> heard;
};

TEST_F(SessionFileTest, TellsAListenerTheTopicAndEachMessageWithAndWithoutAFile) {
  HeardTopics listener;
  SessionFile file;
  write(file, 1);
  file.listen(&listener);
  file.write("/text", 5, ros_messages::String{"before"});
  file.open(path, 1);
  file.write("/text", 6, ros_messages::String{"in the first file"});
  file.write("/other", 7, ros_messages::String{"in another file"});
  file.listen(nullptr);
  file.write("/text", 8, ros_messages::String{"unheard"});
  file.finish();
  EXPECT_EQ(listener.heard,
            (std::vector<std::string>{"1 is /text, std_msgs/msg/String, string data\n",
                                      "1 at 5: before",
                                      "1 at 6: in the first file",
                                      "2 is /other, std_msgs/msg/String, string data\n",
                                      "2 at 7: in another file"}));
  EXPECT_EQ(all_texts().size(), 5U) << "of all parts";
}

TEST_F(SessionFileTest, HasWhatWasWrittenBeforeItWasOpened) {
  SessionFile file;
  file.describe("session", {{"robot", "uno"}});
  write(file, 2);
  file.open(path);
  write(file, 1);
  file.finish();
  EXPECT_EQ(read(path),
            (std::vector<std::string>{"metadata session", "metadata part", "0", "1", "0"}));
  EXPECT_EQ(mcap::McapReader(path).header().profile, "ros2");
}

TEST_F(SessionFileTest, EachPartSaysWhatTheSessionIs) {
  SessionFile file({.chunk_bytes = 1000});
  file.describe("session", {});
  file.describe({0, 0, "robot.toml", "text/plain", {}});
  file.open(path, 2000);
  write(file, 400);
  file.finish();
  std::vector<std::string> texts;
  std::size_t parts = 0;
  for (; exists(part_of(path, parts)); ++parts) {
    auto part = read(part_of(path, parts));
    ASSERT_GT(part.size(), 3U);
    EXPECT_EQ(part[0], "metadata session");
    EXPECT_EQ(part[1], "metadata part");
    EXPECT_EQ(part[2], "attachment robot.toml");
    texts.insert(texts.end(), part.begin() + 3, part.end());
  }
  EXPECT_GT(parts, 2U);
  ASSERT_EQ(texts.size(), 400U);
  EXPECT_EQ(texts.back(), "399");
  EXPECT_EQ(part_of(path, 2), scratch / "session_2.mcap");
}

TEST_F(SessionFileTest, SaysWhatTheSessionIsBeforeWhateverWasWrittenFirst) {
  SessionFile file;
  for (std::uint64_t i = 0; i < 60; ++i) {
    file.write("/text", 1'000'000'000 * i, ros_messages::String{"early"});
    file.flush();
  }
  file.describe("session", {});
  file.open(path);
  file.finish();
  const auto texts = read(path);
  EXPECT_EQ(texts.front(), "metadata session");
  EXPECT_EQ(texts.size(), 62U);
}

/// Writes numbered texts; answers how often that failed.
int write_texts(SessionFile& file, int from, int to) {
  int failed = 0;
  for (int i = from; i < to; ++i) {
    try {
      file.write("/text", static_cast<std::uint64_t>(i), ros_messages::String{std::to_string(i)});
    } catch (const files::FileError&) {
      ++failed;
    }
  }
  return failed;
}

TEST_F(SessionFileTest, APartThatCannotBeMadeIsTriedAgain) {
  std::filesystem::create_directories(part_of(path, 1));
  SessionFile file({.chunk_bytes = 1000});
  file.open(path, 2000);
  EXPECT_GT(write_texts(file, 0, 300), 0);
  std::filesystem::remove(part_of(path, 1));
  EXPECT_EQ(write_texts(file, 300, 400), 0);
  file.finish();
  const auto texts = all_texts();
  ASSERT_EQ(texts.size(), 400U);
  EXPECT_EQ(texts.back(), "399");
}

TEST_F(SessionFileTest, AFullDiskAtASplitLosesNothing) {
  SessionFile file({.chunk_bytes = 1000});
  file.open(path, 2000);
  EXPECT_EQ(write_texts(file, 0, 20), 0);
  {
    const tests::FileSizeLimit limit(100);
    EXPECT_GT(write_texts(file, 20, 300), 0);
    EXPECT_THROW(file.attach({}), files::FileError);
  }
  EXPECT_EQ(write_texts(file, 300, 400), 0);
  file.finish();
  const auto texts = all_texts();
  ASSERT_EQ(texts.size(), 400U);
  EXPECT_EQ(texts.back(), "399");
}

TEST_F(SessionFileTest, ThrowsWhereItCannotBeMade) {
  SessionFile file;
  EXPECT_THROW(file.open("/nowhere/session.mcap"), files::FileError);
  file.open(path);
}

}  // namespace
}  // namespace echomap::recording
