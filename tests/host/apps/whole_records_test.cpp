// SPDX-License-Identifier: MIT
#include "host/apps/whole_records.hpp"

#include <memory>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "host/datasets/open_log.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/support/bag_writer.hpp"

namespace echomap::apps {
namespace {

class WholeRecords : public ::testing::Test {
 protected:
  WholeRecords() {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(
        "test", std::make_shared<spdlog::sinks::ostream_sink_st>(said_)));
  }
  ~WholeRecords() override { spdlog::set_default_logger(before_); }

  /// How many records a trajectory of that text has.
  std::size_t records_of(const std::string& text) {
    files::write_text_file(folder_ / "poses.tum", text);
    const auto log = datasets::open_log(folder_ / "poses.tum", "");
    std::size_t records = 0;
    while (next_whole_record(*log)) {
      ++records;
    }
    return records;
  }

  const session::TemporaryFolder folder_;
  std::ostringstream said_;

 private:
  std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

TEST_F(WholeRecords, AreAllOfAWholeLog) {
  EXPECT_EQ(records_of("0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n"), 2U);
  EXPECT_EQ(records_of("0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1"), 2U) << "only its end is missing";
  EXPECT_EQ(said_.str(), "");
}

TEST_F(WholeRecords, AreThoseBeforeALastLineThatIsCutOffWhichIsTold) {
  EXPECT_EQ(records_of("0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0"), 2U);
  EXPECT_NE(said_.str().find("the end of the log is incomplete"), std::string::npos) << said_.str();
  EXPECT_NE(said_.str().find("poses.tum:3: "), std::string::npos) << said_.str();
}

TEST_F(WholeRecords, OfABagAreBesideAWarningOfWhatIsNotUsed) {
  tests::BagWriter bag(folder_ / "drive.mcap");
  bag.write("/odom", tests::ros_odometry(1.0, {}), 1.0);
  bag.write("/fused", tests::ros_odometry(1.0, {}), 1.0);
  bag.finish();
  const auto log = open_reported_log(folder_ / "drive.mcap", "");
  EXPECT_NE(said_.str().find("drive.mcap: /fused is ignored"), std::string::npos) << said_.str();
  EXPECT_TRUE(next_whole_record(*log));
  EXPECT_FALSE(next_whole_record(*log));
}

TEST_F(WholeRecords, AreNotThereOfALogThatIsDamagedBefore) {
  for (const char* text : {"0 0 0 0 0 0 0 1\n1 1 0 0\n2 2 0 0 0 0 0 1\n",
                           "0 0 0 0 0 0 0 1\n1 1 0 0\n2 2 0 0",
                           "0 0 0 0 0 0 0 1\n1 1 0 0\n",
                           "0 0 0"}) {
    EXPECT_THROW(records_of(text), files::FileError) << text;
  }
  EXPECT_EQ(said_.str(), "");
}

}  // namespace
}  // namespace echomap::apps
