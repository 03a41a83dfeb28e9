// SPDX-License-Identifier: MIT
#include "host/recording/session_file.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/ros_messages/std_msgs.hpp"
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
  std::vector<std::string> read(const std::filesystem::path& path) {
    std::vector<std::string> read;
    mcap::McapReader reader(path);
    while (const auto record = reader.next()) {
      if (const auto* message = std::get_if<mcap::Message>(&*record)) {
        read.push_back(ros_messages::deserialize<ros_messages::String>(message->data).data);
      } else if (const auto* metadata = std::get_if<mcap::Metadata>(&*record)) {
        read.push_back("metadata " + metadata->name);
      } else {
        read.push_back("attachment " + std::get<mcap::Attachment>(*record).name);
      }
    }
    return read;
  }

  const tests::ScratchFolder scratch;
  const std::filesystem::path path = scratch / "session.mcap";
};

TEST_F(SessionFileTest, HasWhatWasWrittenBeforeItWasOpened) {
  SessionFile file;
  file.describe("session", {{"robot", "uno"}});
  write(file, 2);
  file.open(path);
  write(file, 1);
  file.finish();
  EXPECT_EQ(read(path), (std::vector<std::string>{"metadata session", "0", "1", "0"}));
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
    ASSERT_GT(part.size(), 2U);
    EXPECT_EQ(part[0], "metadata session");
    EXPECT_EQ(part[1], "attachment robot.toml");
    texts.insert(texts.end(), part.begin() + 2, part.end());
  }
  EXPECT_GT(parts, 2U);
  ASSERT_EQ(texts.size(), 400U);
  EXPECT_EQ(texts.back(), "399");
  EXPECT_EQ(part_of(path, 2), scratch / "session_2.mcap");
}

TEST_F(SessionFileTest, ThrowsWhereItCannotBeMade) {
  SessionFile file;
  EXPECT_THROW(file.open("/nowhere/session.mcap"), files::FileError);
  file.open(path);
}

}  // namespace
}  // namespace echomap::recording
