// SPDX-License-Identifier: MIT
#include "host/fleet_member/source_recorder.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::fleet_member {
namespace {

constexpr double kBatchS = 4.0;

class SourceRecorderTest : public testing::Test {
 protected:
  SourceRecorderTest() { params_.dead_time_s = 0.001; }

  sensors::RobotGeometry geometry_ = [] {
    sensors::RobotGeometry geometry;
    geometry.track_m = 0.14;
    return geometry;
  }();
  source_search::SourceReadingsParams params_;
};

/// One reading of 0.1 s that ends then.
sensors::ScalarObservation counted(double at_s, double pulses) {
  return {tests::pose_at(at_s, {}).stamp, {}, pulses, 0.1};
}

TEST_F(SourceRecorderTest, HoldsReadingsBackBeforeTheFirstSubmap) {
  const team_map::SubmapRecorder submaps(geometry_);
  SourceRecorder recorder(submaps, params_, kBatchS);
  for (int i = 1; i <= 100; ++i) {
    recorder.on(counted(0.1 * i, 1.0));
  }
  EXPECT_FALSE(recorder.take());
}

TEST_F(SourceRecorderTest, MakesReadingsInARowOneAndBatchesOfThem) {
  team_map::SubmapRecorder submaps(geometry_);
  SourceRecorder recorder(submaps, params_, kBatchS);
  const auto stamp = tests::pose_at(0.0, {}).stamp;
  submaps.on(sensors::BeginScan{});
  submaps.on(sensors::SonarObservation{stamp, {}, 0.0, 1.0, true});
  submaps.on(sensors::EndScan{});
  ASSERT_EQ(submaps.submaps().size(), 1U);
  for (int i = 1; i <= 30; ++i) {
    recorder.on(counted(0.1 * i, 2.0));
  }
  EXPECT_FALSE(recorder.take()) << "not long enough";
  for (int i = 31; i <= 90; ++i) {
    recorder.on(counted(0.1 * i, 2.0));
  }
  const auto batch = recorder.take();
  ASSERT_TRUE(batch);
  EXPECT_EQ(batch->submap_index, 0U);
  ASSERT_GE(batch->readings.size(), 2U);
  const auto& first = batch->readings.front();
  EXPECT_EQ(first.value, 2.0 * 20);
  EXPECT_NEAR(first.dwell_s, 20 * (0.1 - 0.002), 1e-9) << "without the dead time of its pulses";
  EXPECT_FALSE(recorder.take()) << "each once";

  double recorded = 0.0;
  for (const auto& reading : batch->readings) {
    recorded += reading.value;
  }
  const auto rest = recorder.take_rest();
  ASSERT_TRUE(rest) << "however short";
  for (const auto& reading : rest->readings) {
    recorded += reading.value;
  }
  EXPECT_EQ(recorded, 2.0 * 90);
  EXPECT_FALSE(recorder.take_rest());
}

TEST_F(SourceRecorderTest, RefusesBatchesOfNoTime) {
  const team_map::SubmapRecorder submaps(geometry_);
  EXPECT_THROW(SourceRecorder(submaps, params_, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::fleet_member
