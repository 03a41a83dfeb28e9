// SPDX-License-Identifier: MIT
#include "host/datasets/merged_log.hpp"

#include <deque>

#include <gmock/gmock.h>

#include "host/datasets/tum_log.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::datasets {
namespace {

/// Headings with these stamps; the heading is the name of the log.
class ListLog : public LogReader {
 public:
  ListLog(double name, std::deque<std::optional<double>> stamps)
      : name_(name), stamps_(std::move(stamps)) {}

  std::optional<LogRecord> next() override {
    if (stamps_.empty()) {
      return std::nullopt;
    }
    const auto stamp_s = stamps_.front();
    stamps_.pop_front();
    return Heading{stamp_s, name_};
  }
  double progress() const override { return stamps_.empty() ? 1.0 : 0.0; }

 private:
  double name_;
  std::deque<std::optional<double>> stamps_;
};

TEST(MergedLog, TakesTheEarliestAndAnUnstampedRecordRightAfterTheOneBeforeIt) {
  std::vector<std::unique_ptr<LogReader>> logs;
  logs.push_back(std::make_unique<ListLog>(1.0, std::deque<std::optional<double>>{1.0, 3.0, 4.0}));
  logs.push_back(
      std::make_unique<ListLog>(2.0, std::deque<std::optional<double>>{2.0, std::nullopt, 3.0}));
  MergedLog log(std::move(logs));
  EXPECT_EQ(log.progress(), 0.0);
  std::vector<double> names;
  for (const auto& heading : tests::only<Heading>(tests::records_of(log))) {
    names.push_back(heading.heading_rad);
  }
  EXPECT_THAT(names, ::testing::ElementsAre(1.0, 2.0, 2.0, 1.0, 2.0, 1.0));
  EXPECT_EQ(log.progress(), 1.0);
}

TEST(MergedLog, KeepsHalfALineAtTheEndOfOneUntilTheOthersHaveEndedToo) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "short.tum", "1 1 0 0 0 0 0 1\n2 2 0");
  files::write_text_file(folder / "long.tum", "3 3 0 0 0 0 0 1\n4 4 0 0 0 0 0 1\n");
  std::vector<std::unique_ptr<LogReader>> logs;
  logs.push_back(open_tum_log(folder / "short.tum"));
  logs.push_back(open_tum_log(folder / "long.tum"));
  MergedLog log(std::move(logs));
  for (int record = 0; record < 3; ++record) {
    EXPECT_TRUE(log.next()) << record;
  }
  EXPECT_THROW(log.next(), CutOffLine);
  EXPECT_FALSE(log.next());
}

}  // namespace
}  // namespace echomap::datasets
