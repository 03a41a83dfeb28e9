// SPDX-License-Identifier: MIT
#include "host/datasets/nxt_scan_log.hpp"

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class NxtScanLogTest : public tests::LogTest {
 protected:
  NxtScanLogTest() : LogTest("scan.dat", open_nxt_scan_log) {}
};

TEST_F(NxtScanLogTest, TheFileIsOneScanAllRound) {
  const auto records = read("100\n50.0\n25\n10\n");
  ASSERT_EQ(records.size(), 1U);
  const auto& beams = std::get<sensors::RangeScan>(records[0]).beams;
  ASSERT_EQ(beams.size(), 4U);
  EXPECT_EQ(beams[0], (sensors::Beam{0.0, 1.0}));
  EXPECT_DOUBLE_EQ(beams[1].bearing_rad, geometry::radians(90.0));
  EXPECT_DOUBLE_EQ(beams[3].bearing_rad, geometry::radians(-90.0));
}

TEST_F(NxtScanLogTest, TwoHundredFiftyFiveIsNoReturn) {
  const auto scan = tests::only<sensors::RangeScan>(read("255\n254\n")).at(0);
  EXPECT_EQ(scan.beams[0].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[1].range_m, 2.54);
}

TEST_F(NxtScanLogTest, AnEmptyFileHasNoScanAndALongOneIsRefused) {
  EXPECT_TRUE(read("").empty());
  EXPECT_THAT(error_of(tests::repeated("1\n", 3601)), HasSubstr("scan.dat:3601: more ranges"));
  EXPECT_THAT(error_of("1 2\n"), HasSubstr("scan.dat:1: '2' follows"));
}

TEST(RealNxtScans, Have72Ranges) {
  for (const char* file : {"place_train_loc_00.dat", "place_test_loc_04.dat"}) {
    const auto path = tests::real_data("nxt_sonar_imperial") / file;
    ECHOMAP_SKIP_WITHOUT(path);
    const auto scan =
        tests::only<sensors::RangeScan>(tests::records_of(*open_nxt_scan_log(path))).at(0);
    ASSERT_EQ(scan.beams.size(), 72U);
    EXPECT_DOUBLE_EQ(scan.beams[1].bearing_rad, geometry::radians(5.0));
  }
}

}  // namespace
}  // namespace echomap::datasets
