// SPDX-License-Identifier: MIT
#include "host/pipeline/replaced_poses.hpp"

#include <memory>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {
namespace {

using datasets::GivenPose;
using datasets::LogRecord;
using datasets::OdometryPose;
using sensors::RangeScan;

class ToldLog final : public datasets::LogReader {
 public:
  explicit ToldLog(std::vector<LogRecord> records) : records_(std::move(records)) {}
  std::optional<LogRecord> next() override {
    return at_ < records_.size() ? std::optional(records_[at_++]) : std::nullopt;
  }
  double progress() const override { return 0.25; }

 private:
  std::vector<LogRecord> records_;
  std::size_t at_ = 0;
};

std::vector<LogRecord> all_of(datasets::LogReader& log) {
  std::vector<LogRecord> records;
  while (auto record = log.next()) {
    records.push_back(std::move(*record));
  }
  return records;
}

TEST(ReplacedPoses, StandInPlaceOfTheOdometryAndOfThoseOfTheLog) {
  ReplacedPoses log(
      std::make_unique<ToldLog>(std::vector<LogRecord>{OdometryPose{1.0, {1.0, 0.0, 0.0}},
                                                       GivenPose{1.0, {9.0, 9.0, 0.0}},
                                                       sensors::RangeScan{},
                                                       datasets::GivenPosition{},
                                                       OdometryPose{2.0, {2.0, 0.0, 0.0}}}),
      {{3.0, 0.0, 0.0}, {4.0, 0.0, 0.0}});

  const auto records = all_of(log);

  ASSERT_EQ(records.size(), 3U);
  EXPECT_DOUBLE_EQ(std::get<GivenPose>(records[0]).T_map_robot.x_m(), 3.0);
  EXPECT_EQ(std::get<GivenPose>(records[0]).stamp_s, 1.0);
  EXPECT_TRUE(std::holds_alternative<sensors::RangeScan>(records[1]));
  EXPECT_DOUBLE_EQ(std::get<GivenPose>(records[2]).T_map_robot.x_m(), 4.0);
}

TEST(ReplacedPoses, EndWithTheTrajectoryOfALogThatWasReadInPart) {
  ReplacedPoses log(
      std::make_unique<ToldLog>(std::vector<LogRecord>{OdometryPose{}, OdometryPose{}}), {{}});

  EXPECT_EQ(all_of(log).size(), 1U);
  EXPECT_DOUBLE_EQ(log.progress(), 0.25);
}

}  // namespace
}  // namespace echomap::pipeline
