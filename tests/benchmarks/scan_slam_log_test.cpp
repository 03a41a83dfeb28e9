// SPDX-License-Identifier: MIT
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/slam/scan_slam.hpp"
#include "tests/benchmarks/relation_log.hpp"
#include "tests/benchmarks/spoilt_log.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

evaluation::RelationError scored(const RelationLog& log) {
  slam::ScanSlam method;
  return score_slam(log, method);
}

TEST(ScanSlamOnLogs, EdmontonIsAsGoodAsTheBestPeer) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations"));
  const auto log = *read_relation_log("edm");
  EXPECT_LT(scored(log).translation_mean_m, 0.06) << "LaMa 0.077 m";
}

TEST(ScanSlamOnLogs, FewBeamsOfEdmontonAreStillBetterThanOdometry) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations"));
  const auto log = *read_relation_log("edm");
  EXPECT_LT(scored(with_beams(log, 60)).translation_mean_m, 0.085);
  EXPECT_LT(scored(with_beams(log, 36)).translation_mean_m, 0.09);
  EXPECT_LT(scored(with_beams(log, 24)).translation_mean_m, 0.09);
  EXPECT_LT(scored(with_beams(log, 12)).translation_mean_m, 0.11) << "odometry 0.262 m";
}

TEST(ScanSlamOnLogs, FreiburgsOdometryIsMetresOffAndDoesNotMatter) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("slam_relations"));
  const auto error = scored(*read_relation_log("fr079"));
  EXPECT_LT(error.translation_mean_m, 0.045);
  EXPECT_LT(geometry::degrees(error.rotation_mean_rad), 0.46);
}

TEST(ScanSlamOnLogs, RarelyLosesItselfWhereOdometryTurnsAmissFromOneThinScanToTheNext) {
  ECHOMAP_SKIP_WITHOUT(tests::real_data("carmen_corrected"));
  int lost = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    for (const auto& [file, every] : {std::pair("carmen_corrected/csail-corrected", 1U),
                                      std::pair("carmen_corrected/freiburg-079-corrected", 8U)}) {
      std::mt19937 random(seed);
      lost += scored(*read_spoilt_log(file, every, random)).translation_mean_m > 0.1 ? 1 : 0;
    }
  }
  EXPECT_LE(lost, 1) << "of 16; 5 while a match was left only for one with 10 % more on surfaces";
}

}  // namespace
}  // namespace echomap::bench
