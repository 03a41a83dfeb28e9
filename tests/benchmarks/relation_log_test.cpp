// SPDX-License-Identifier: MIT
#include "tests/benchmarks/relation_log.hpp"

#include <variant>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

const sensors::RangeScan& first_scan(const RelationLog& log) {
  for (const auto& record : log.records) {
    if (const auto* scan = std::get_if<sensors::RangeScan>(&record)) {
      return *scan;
    }
  }
  throw std::logic_error("no scan");
}

/// A scan of 180 beams, the `i`th of 1 m + i cm.
RelationLog slanted_log() {
  sensors::RangeScan scan;
  for (int i = 0; i < 180; ++i) {
    scan.beams.push_back({geometry::radians(i - 90.0), 1.0 + 0.01 * i});
  }
  return {{scan}, {}};
}

TEST(RelationLog, OdometryOfEachScoresTheKnownError) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations"));
  const auto edmonton = score_odometry(*read_relation_log("edm"));
  EXPECT_NEAR(edmonton.translation_mean_m, 0.262, 0.0005);
  EXPECT_NEAR(geometry::degrees(edmonton.rotation_mean_rad), 2.20, 0.005);
  EXPECT_NEAR(score_odometry(*read_relation_log("fr079")).translation_mean_m, 6.51, 0.005);
}

TEST(RelationLog, BeamsAreThoseOfThePublicThinLogs) {
  const RelationLog thin = with_beams(slanted_log(), 12);
  const auto& beams = first_scan(thin).beams;
  ASSERT_EQ(beams.size(), 12U);
  EXPECT_NEAR(geometry::degrees(beams.front().bearing_rad), 7.0 - 90.0, 1e-9);
  EXPECT_NEAR(geometry::degrees(beams.back().bearing_rad), 172.0 - 90.0, 1e-9);
}

TEST(RelationLog, AConeHearsTheNearestOfItsBeams) {
  std::mt19937 random(1);
  const RelationLog cones = with_cones(slanted_log(), 12, random);
  const auto& scan = first_scan(cones);
  ASSERT_EQ(scan.beams.size(), 12U);
  EXPECT_NEAR(*scan.beams[0].range_m, 1.0, 0.05) << "beams 0 to 14";
  EXPECT_NEAR(*scan.beams[11].range_m, 2.65, 0.05) << "beams 165 to 179";
  EXPECT_NEAR(geometry::degrees(scan.beam_width_rad), 15.0, 1e-9);
}

}  // namespace
}  // namespace echomap::bench
