// SPDX-License-Identifier: MIT
#include "tests/benchmarks/spoilt_log.hpp"

#include <variant>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

constexpr const char* kLog = "carmen_corrected/belgioioso-corrected";

std::size_t scans(const RelationLog& log) {
  std::size_t count = 0;
  for (const auto& record : log.records) {
    count += std::holds_alternative<sensors::RangeScan>(record) ? 1 : 0;
  }
  return count;
}

double odometry_error_m(std::uint32_t seed, std::size_t every = 1) {
  std::mt19937 random(seed);
  return score_odometry(*read_spoilt_log(kLog, every, random)).translation_mean_m;
}

TEST(SpoiltLog, HasBadOdometryByItsSeed) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("carmen_corrected"));
  EXPECT_GT(odometry_error_m(1), 0.5);
  EXPECT_EQ(odometry_error_m(1), odometry_error_m(1));
  EXPECT_NE(odometry_error_m(1), odometry_error_m(2));
}

TEST(SpoiltLog, KeepsEveryNthScanAndRelatesPlacesThatAreNear) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("carmen_corrected"));
  std::mt19937 random(1);
  const auto whole = *read_spoilt_log(kLog, 1, random);
  const auto third = *read_spoilt_log(kLog, 3, random);
  EXPECT_EQ(scans(third), (scans(whole) + 2) / 3);
  bool is_revisited = false;
  for (const auto& relation : whole.relations) {
    EXPECT_LT(relation.T_from_to.position_m().norm(), 3.0);
    is_revisited = is_revisited || relation.to > relation.from + 20;
  }
  EXPECT_TRUE(is_revisited);
}

TEST(SpoiltLog, IsEmptyWithoutTheData) {
  std::mt19937 random(1);
  EXPECT_FALSE(read_spoilt_log("carmen_corrected/there is no such log", 1, random));
}

}  // namespace
}  // namespace echomap::bench
