// SPDX-License-Identifier: MIT
#include "host/mcap/mcap_writer.hpp"

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "host/files/atomic_file.hpp"
#include "tests/host/mcap/small_file.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mcap {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

class McapWriterTest : public testing::Test {
 protected:
  fs::path path() const { return folder_ / "run.mcap"; }

 private:
  tests::ScratchFolder folder_;
};

TEST_F(McapWriterTest, WritesWhatAReaderReads) {
  for (const auto compression : {Compression::kNone, Compression::kZstd, Compression::kLz4}) {
    write_small_file(path(), compression);
    const ReadOut read = read_out(path());
    EXPECT_THAT(read.lines, ElementsAreArray(small_session_lines()));
    EXPECT_EQ(read.error, "");
  }
}

TEST_F(McapWriterTest, WritesTheSameBytesForTheSameCalls) {
  write_small_file(path());
  const Bytes first = load_bytes(path());
  write_small_file(path());
  EXPECT_EQ(load_bytes(path()), first);
}

TEST_F(McapWriterTest, WritesTheSameBytesHoweverLateTheFileIsOpened) {
  write_small_file(path());
  const Bytes first = load_bytes(path());
  fs::remove(path());
  McapWriter writer({"ros2", "echomap test"}, small_chunks());
  write_small_session(writer);
  writer.finish();
  EXPECT_FALSE(fs::exists(path()));
  writer.open(path());
  EXPECT_EQ(load_bytes(path()), first);
  EXPECT_EQ(writer.bytes_written(), first.size());
}

TEST_F(McapWriterTest, WritesAllThatCameBeforeTheFileWhenItIsOpened) {
  McapWriter writer({"ros2", ""});
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  writer.write(channel, 1, 1, bytes_of("before"));
  writer.open(path());
  EXPECT_THAT(read_out(path()).lines, ElementsAre("/log 0 1 1 before"));
  writer.write(channel, 2, 2, bytes_of("after"));
  writer.finish();
  EXPECT_THAT(read_out(path()).lines, ElementsAre("/log 0 1 1 before", "/log 1 2 2 after"));
}

TEST_F(McapWriterTest, LeavesNoFileWhereNoneWasOpened) {
  {
    McapWriter writer({"ros2", ""});
    write_small_session(writer);
    EXPECT_EQ(writer.bytes_written(), 0U);
  }
  EXPECT_FALSE(fs::exists(path()));
}

TEST_F(McapWriterTest, EndsTheFileWhenItIsDestroyed) {
  {
    McapWriter writer({"ros2", "echomap test"}, small_chunks());
    writer.open(path());
    write_small_session(writer);
  }
  EXPECT_THAT(read_out(path()).lines, ElementsAreArray(small_session_lines()));
  EXPECT_EQ(read_out(path()).error, "");
}

TEST_F(McapWriterTest, ReplacesAnOlderFile) {
  save_bytes(path(), Bytes(100000, 1));
  write_small_file(path());
  EXPECT_LT(fs::file_size(path()), 5000U);
}

TEST_F(McapWriterTest, WritesAChunkWhenItIsFull) {
  McapWriterParams params;
  params.chunk_bytes = 1000;
  McapWriter writer({"", ""}, params);
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  writer.open(path());
  const std::uint64_t header_bytes = writer.bytes_written();
  writer.write(channel, 0, 0, Bytes(400));
  EXPECT_EQ(writer.bytes_written(), header_bytes);
  writer.write(channel, 1, 1, Bytes(600));
  EXPECT_GT(writer.bytes_written(), header_bytes);
  EXPECT_EQ(read_out(path()).messages.size(), 2U);
}

TEST_F(McapWriterTest, WritesAChunkWhenItsTimeIsOver) {
  McapWriter writer({"", ""});
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  writer.open(path());
  writer.write(channel, 5'000'000'000, 0, bytes_of("a"));
  writer.write(channel, 1'000'000'000, 0, bytes_of("b"));
  writer.write(channel, 8'999'999'999, 0, bytes_of("c"));
  EXPECT_THAT(read_out(path()).messages, IsEmpty());
  writer.write(channel, 9'000'000'000, 0, bytes_of("d"));
  EXPECT_EQ(read_out(path()).messages.size(), 3U);
}

TEST_F(McapWriterTest, LosesNothingThatWasFlushedWhenItIsKilled) {
  const pid_t child = ::fork();
  if (child == 0) {
    McapWriter writer({"ros2", ""});
    writer.open(path());
    const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
    writer.write(channel, 1, 2, bytes_of("flushed"));
    writer.flush();
    writer.write(channel, 3, 4, bytes_of("lost"));
    ::raise(SIGKILL);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  const ReadOut read = read_out(path());
  EXPECT_THAT(read.lines, ElementsAre("/log 0 1 2 flushed"));
  EXPECT_TRUE(read.is_cut_off) << read.error;
}

TEST_F(McapWriterTest, DefinesAChannelBeforeItsFirstMessage) {
  McapWriter writer({"ros2", ""});
  writer.open(path());
  const std::uint16_t first = writer.add_channel({"/first", 0, "", {}});
  writer.write(first, 0, 0, bytes_of("1"));
  writer.flush();
  const std::uint16_t second = writer.add_channel({"/second", 0, "", {}});
  writer.flush();
  writer.write(second, 0, 0, bytes_of("2"));
  writer.add_channel({"/never used", 0, "", {}});
  writer.flush();
  EXPECT_THAT(read_out(path()).lines, ElementsAre("/first 0 0 0 1", "/second 0 0 0 2"));
}

TEST_F(McapWriterTest, NamesFileAndReasonWhereTheDiskIsFull) {
  McapWriter writer({"ros2", ""});
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { writer.open("/dev/full"); }),
              HasSubstr("/dev/full: No space left on device"));
}

TEST_F(McapWriterTest, MayOpenAnotherFileWhereOneCannotBeCreated) {
  McapWriter writer({"ros2", "echomap test"}, small_chunks());
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { writer.open("/nowhere/run.mcap"); }),
              EndsWith("/nowhere/run.mcap: No such file or directory"));
  writer.open(path());
  EXPECT_THROW(writer.open(path()), std::logic_error);
  write_small_session(writer);
  writer.finish();
  EXPECT_THAT(read_out(path()).lines, ElementsAreArray(small_session_lines()));
}

TEST_F(McapWriterTest, LeavesTheFileReadableWhereTheDiskIsFull) {
  McapWriter writer({"ros2", ""});
  writer.open(path());
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  writer.write(channel, 1, 1, bytes_of("before"));
  writer.flush();
  const std::uint64_t good_bytes = writer.bytes_written();
  writer.write(channel, 2, 2, bytes_of("while it is full"));
  {
    const tests::FileSizeLimit limit(good_bytes + 40);
    EXPECT_THAT(tests::thrown_text<files::FileError>([&] { writer.flush(); }),
                HasSubstr("run.mcap: File too large"));
    EXPECT_EQ(fs::file_size(path()), good_bytes);
    EXPECT_EQ(writer.bytes_written(), good_bytes);
    EXPECT_THAT(read_out(path()).lines, ElementsAre("/log 0 1 1 before"));
    writer.write(channel, 3, 3, bytes_of("still full"));
    EXPECT_THROW(writer.flush(), files::FileError);
    EXPECT_THROW(writer.finish(), files::FileError);
  }
  writer.finish();
  const ReadOut read = read_out(path());
  EXPECT_THAT(
      read.lines,
      ElementsAre("/log 0 1 1 before", "/log 1 2 2 while it is full", "/log 2 3 3 still full"));
  EXPECT_EQ(read.error, "");
}

TEST_F(McapWriterTest, AcceptsTheMessageWhoseChunkCannotBeWritten) {
  McapWriterParams params;
  params.chunk_bytes = 1;
  McapWriter writer({"ros2", ""}, params);
  writer.open(path());
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  {
    const tests::FileSizeLimit limit(writer.bytes_written());
    EXPECT_THROW(writer.write(channel, 1, 1, bytes_of("kept")), files::FileError);
    EXPECT_THROW(writer.attach({0, 0, "a", "", {}}), files::FileError);
    EXPECT_THROW(writer.add_metadata({"m", {}}), files::FileError);
  }
  writer.flush();
  EXPECT_THAT(read_out(path()).lines,
              ElementsAre("/log 0 1 1 kept", "attachment a ", "metadata m"));
}

TEST_F(McapWriterTest, DiesQuietlyWhereTheDiskIsFull) {
  const tests::FileSizeLimit limit(60);
  McapWriter writer({"ros2", ""});
  writer.open(path());
  writer.write(writer.add_channel({"/log", 0, "", {}}), 1, 1, bytes_of("lost"));
}

TEST_F(McapWriterTest, RefusesWhatDoesNotBelongTogether) {
  McapWriter writer({"ros2", ""});
  EXPECT_THROW(writer.write(0, 1, 1, {}), std::invalid_argument);
  EXPECT_THROW(writer.write(1, 1, 1, {}), std::invalid_argument);
  EXPECT_THROW(writer.add_channel({"/log", 1, "", {}}), std::invalid_argument);
  EXPECT_THROW(writer.write(writer.add_channel({"/log", 0, "", {}}), 1, 1, Bytes((64U << 20U) + 1)),
               std::invalid_argument);
}

TEST_F(McapWriterTest, AddsNothingToAFinishedFile) {
  McapWriter writer({"ros2", ""});
  const std::uint16_t channel = writer.add_channel({"/log", 0, "", {}});
  writer.finish();
  EXPECT_THROW(writer.write(channel, 1, 1, {}), std::logic_error);
  EXPECT_THROW(writer.add_schema({}), std::logic_error);
  EXPECT_THROW(writer.add_channel({}), std::logic_error);
  EXPECT_THROW(writer.attach({}), std::logic_error);
  EXPECT_THROW(writer.add_metadata({}), std::logic_error);
  writer.flush();
  writer.finish();
}

TEST_F(McapWriterTest, NamesTheParameterThatIsOutsideOfItsRange) {
  const auto error_of = [](const McapWriterParams& params) {
    return tests::thrown_text<std::invalid_argument>([&] { McapWriter({"", ""}, params); });
  };
  McapWriterParams params;
  params.chunk_bytes = 0;
  EXPECT_EQ(error_of(params), "chunk_bytes = 0 is outside 1 .. 67108864");
  params = {};
  params.chunk_duration_ns = 0;
  EXPECT_EQ(error_of(params), "chunk_duration_ns = 0 is outside 1 ..");
  params = {};
  params.compression_level = 20;
  EXPECT_EQ(error_of(params), "compression_level = 20 is outside 1 .. 19");
}

}  // namespace
}  // namespace echomap::mcap
