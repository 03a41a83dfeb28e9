// SPDX-License-Identifier: MIT
#include "host/datasets/line_log.hpp"

#include <gmock/gmock.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::datasets {
namespace {

/// Gives as many headings as the line has letters, each with the number of its line.
class LetterParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    if (line != "-") {
      const auto number = static_cast<double>(lines.line_number());
      records.insert(records.end(), line.size(), Heading{std::nullopt, number});
    }
  }
};

TEST(LineLog, GivesTheRecordsOfEachLineInTurnAndSkipsBlankLines) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "log", "ab\n-\n \t\n\nc\n");
  LineLog log(folder / "log", std::make_unique<LetterParser>());
  EXPECT_EQ(log.progress(), 0.0);
  std::vector<double> lines;
  for (const auto& heading : tests::only<Heading>(tests::records_of(log))) {
    lines.push_back(heading.heading_rad);
  }
  EXPECT_THAT(lines, ::testing::ElementsAre(1.0, 1.0, 5.0));
  EXPECT_EQ(log.progress(), 1.0);
  EXPECT_FALSE(log.next());
}

}  // namespace
}  // namespace echomap::datasets
