// SPDX-License-Identifier: MIT
#include "host/datasets/line_reader.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LineReaderTest : public ::testing::Test {
 protected:
  std::vector<std::string> lines_of(const std::filesystem::path& path) {
    std::vector<std::string> lines;
    LineReader reader(path);
    while (const auto line = reader.next()) {
      lines.emplace_back(*line);
      EXPECT_EQ(reader.line_number(), lines.size());
    }
    return lines;
  }
  std::vector<std::string> lines_of_text(const std::string& text) {
    files::write_text_file(file_, text);
    return lines_of(file_);
  }
  std::string error_of(const std::filesystem::path& path) {
    return tests::thrown_text<files::FileError>([&] { lines_of(path); });
  }

  tests::ScratchFolder folder_;
  std::filesystem::path file_ = folder_ / "log.txt";
};

TEST_F(LineReaderTest, EndsLinesAtLfAndAtCrLf) {
  EXPECT_THAT(lines_of_text("one\ntwo\r\n\nfour\n"), ElementsAre("one", "two", "", "four"));
}

TEST_F(LineReaderTest, TheLastLineMayLackItsEnd) {
  EXPECT_THAT(lines_of_text("one\ntwo"), ElementsAre("one", "two"));
  EXPECT_THAT(lines_of_text(""), ElementsAre());
}

TEST_F(LineReaderTest, TellsALastLineThatIsCutOffFromOneThatIsDamaged) {
  const auto is_cut_off = [&](const std::string& text,
                              LineReader::Role role = LineReader::Role::kMain) {
    files::write_text_file(file_, text);
    LineReader reader(file_, role);
    while (const auto line = reader.next()) {
      if (*line == "bad") {
        break;
      }
    }
    try {
      reader.fail("no");
    } catch (const CutOffLine&) {
      return true;
    } catch (const files::FileError&) {
      return false;
    }
  };
  EXPECT_TRUE(is_cut_off("one\nbad"));
  EXPECT_FALSE(is_cut_off("one\nbad", LineReader::Role::kCompanion)) << "the main file goes on";
  EXPECT_FALSE(is_cut_off("one\nbad\n"));
  EXPECT_FALSE(is_cut_off("one\nbad\nthree"));
  EXPECT_FALSE(is_cut_off("bad")) << "nothing is whole";
  EXPECT_FALSE(is_cut_off("one\ntwo\n")) << "at its end";
  EXPECT_TRUE(is_cut_off("one\ntwo")) << "at its end";
  const std::string long_lines(2 * LineReader::kMaxLineBytes, '\n');
  EXPECT_TRUE(is_cut_off(long_lines + "bad")) << "behind the edge of its buffer";
}

TEST_F(LineReaderTest, ReadsGzAsIfItWereNotPacked) {
  tests::write_gz(folder_ / "log.gz", "one\ntwo\n");
  EXPECT_THAT(lines_of(folder_ / "log.gz"), ElementsAre("one", "two"));
}

TEST_F(LineReaderTest, LinesOfEveryLengthSurviveTheEdgesOfItsBuffer) {
  std::string text;
  std::vector<std::string> expected;
  for (std::size_t length = 0; length < LineReader::kMaxLineBytes; length = length * 3 + 1) {
    for (const std::size_t size : {length, LineReader::kMaxLineBytes - length}) {
      expected.emplace_back(size, static_cast<char>('a' + expected.size() % 26));
      text += expected.back() + "\n";
    }
  }
  EXPECT_EQ(lines_of_text(text), expected);
}

TEST_F(LineReaderTest, RefusesALineThatIsTooLong) {
  files::write_text_file(file_, "short\n" + std::string(LineReader::kMaxLineBytes + 1, '1') + "\n");
  EXPECT_THAT(error_of(file_), HasSubstr("log.txt:2: the line is longer than 65536 bytes"));
}

TEST_F(LineReaderTest, RefusesAZeroByte) {
  files::write_text_file(file_, std::string("1 2\n3 \0 4\n", 10));
  EXPECT_THAT(error_of(file_), HasSubstr("log.txt:2: the line contains a zero byte"));
}

TEST_F(LineReaderTest, RefusesGzDataThatAreCutOff) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += std::to_string(i * 7919 % 10007) + "\n";
  }
  tests::write_gz(folder_ / "log.gz", text);
  std::filesystem::resize_file(folder_ / "log.gz",
                               std::filesystem::file_size(folder_ / "log.gz") / 2);
  EXPECT_THAT(error_of(folder_ / "log.gz"), HasSubstr("log.gz:"));
  EXPECT_THAT(error_of(folder_ / "log.gz"), HasSubstr("cannot read on: unexpected end of file"));
}

TEST_F(LineReaderTest, NamesWhatCannotBeOpened) {
  EXPECT_THAT(error_of(folder_ / "none"), HasSubstr("none: No such file"));
  EXPECT_THAT(error_of(folder_.path()), HasSubstr("Is a directory"));
}

TEST_F(LineReaderTest, AGigabyteOfZerosInAMegabyteOfGzIsRefusedInLittleMemory) {
  constexpr std::size_t kPiece = std::size_t{1} << 24U;
  tests::write_gz(folder_ / "piece.gz", std::string(kPiece, '\0'));
  const std::string piece = files::read_text_file(folder_ / "piece.gz");
  std::string bomb;
  for (int i = 0; i < 64; ++i) {
    bomb += piece;
  }
  files::write_text_file(folder_ / "bomb.gz", bomb);
  rusage before{};
  ::getrusage(RUSAGE_SELF, &before);
  EXPECT_THAT(error_of(folder_ / "bomb.gz"), HasSubstr("bomb.gz:1: the line is longer than"));
  rusage after{};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 4096) << "kilobytes";
}

TEST_F(LineReaderTest, ProgressGoesFromNothingToAll) {
  files::write_text_file(file_, std::string(1000000, '\n'));
  LineReader reader(file_);
  EXPECT_EQ(reader.progress(), 0.0);
  double last = 0.0;
  while (reader.next()) {
    EXPECT_GE(reader.progress(), last);
    last = reader.progress();
  }
  EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace echomap::datasets
