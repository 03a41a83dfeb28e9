// SPDX-License-Identifier: MIT
#include "host/datasets/uci_ring_log.hpp"

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using ::testing::HasSubstr;

class UciRingLogTest : public tests::LogTest {
 protected:
  UciRingLogTest() : LogTest("sensor_readings_24.csv", open_uci_ring_log) {}
};

TEST_F(UciRingLogTest, TheRingGoesClockwiseFromTheFront) {
  const auto scan =
      tests::only<sensors::RangeScan>(read(tests::repeated("1.5,", 24) + "Sharp-Right-Turn\n"))
          .at(0);
  ASSERT_EQ(scan.beams.size(), 24U);
  EXPECT_EQ(scan.beams[0], (sensors::Beam{0.0, 1.5}));
  EXPECT_DOUBLE_EQ(scan.beams[1].bearing_rad, radians(-15.0));
  EXPECT_DOUBLE_EQ(scan.beams[6].bearing_rad, radians(-90.0));
  EXPECT_DOUBLE_EQ(scan.beams[18].bearing_rad, radians(90.0));
  EXPECT_EQ(scan.stamp_s, std::nullopt);
}

TEST_F(UciRingLogTest, FiveMetresAndMoreAreNoReturn) {
  const auto scan = tests::only<sensors::RangeScan>(
                        read("5.000,5.087,4.999," + tests::repeated("1,", 21) + "X\n"))
                        .at(0);
  EXPECT_EQ(scan.beams[0].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[1].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[2].range_m, 4.999);
}

TEST_F(UciRingLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of(tests::repeated("1,", 23) + "X\n"), HasSubstr(":1: a range is 'X'"));
}

TEST(RealUciRingLog, Has5456ScansOfWhich13Point8PercentAreSilent) {
  const auto path = tests::real_data("uci_wall_following/sensor_readings_24.csv.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto scans = tests::only<sensors::RangeScan>(tests::records_of(*open_uci_ring_log(path)));
  ASSERT_EQ(scans.size(), 5456U);
  std::size_t silent = 0;
  for (const auto& scan : scans) {
    for (const auto& beam : scan.beams) {
      silent += beam.range_m ? 0 : 1;
    }
  }
  EXPECT_NEAR(static_cast<double>(silent) / (5456.0 * 24.0), 0.138, 0.002);
}

}  // namespace
}  // namespace echomap::datasets
