// SPDX-License-Identifier: MIT
#include "host/localization/stop_scan.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;
using geometry::radians;

RangeReading towards(double bearing_deg, double range_m) {
  return {{0.0, 0.0, radians(bearing_deg)}, range_m};
}

TEST(StopScan, JoinsScansAtTheNewest) {
  const StopScan newest{{1.0, 0.0, radians(90.0)}, {towards(0.0, 1.0)}, {}};
  const StopScan before{{0.0, 0.0, 0.0}, {}, {towards(0.0, 2.0)}};
  const std::vector<StopScan> scans = {newest, before};
  const auto readings = joined(scans);
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].range_m, 1.0);
  EXPECT_EQ(readings[1].range_m, 2.0) << "what was heard on the way counts";
  EXPECT_NEAR(readings[1].T_robot_sensor.x_m(), 0.0, 1e-12);
  EXPECT_NEAR(readings[1].T_robot_sensor.y_m(), 1.0, 1e-12);
  EXPECT_NEAR(readings[1].T_robot_sensor.heading_rad(), radians(-90.0), 1e-12);
}

TEST(StopScan, HasSectorsOfTheTurnAndPiecesOfTheWay) {
  StopScan scan;
  for (int bearing_deg = -175; bearing_deg < 180; bearing_deg += 10) {
    scan.readings.push_back(towards(bearing_deg, 1.0));
    scan.on_the_way.push_back(towards(0.0, 0.01 * (bearing_deg + 175)));
  }
  const auto sectors = sectors_of(scan, 6);
  ASSERT_EQ(sectors.size(), 12U);
  for (const auto& readings : sectors) {
    EXPECT_EQ(readings.size(), 6U);
  }
  for (const RangeReading& reading : sectors[6]) {
    EXPECT_LT(reading.range_m.value(), 0.6) << "the first piece of the way";
  }
}

TEST(StopScan, LeavesOutWhatIsASingleReading) {
  const StopScan scan{
      {}, {towards(10.0, 1.0), towards(11.0, 1.0), towards(100.0, 1.0)}, {towards(0.0, 1.0)}};
  EXPECT_EQ(sectors_of(scan, 6).size(), 1U);
}

}  // namespace
}  // namespace echomap::localization
