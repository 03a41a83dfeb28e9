// SPDX-License-Identifier: MIT
// Singh and Bedi 2013, section 4: the robot that was carried off is looked for by 250 particles in
// the cloud of echoes that it has mapped before, with ten rounds of eight readings.
#include "host/papers/nxt_room.hpp"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/support/offline_exploration.hpp"

namespace echomap::papers {
namespace {

constexpr int kStarts = 60;

/// Of `kStarts` robots, each or its twin.
struct NxtRates {
  int right = 0;                    ///< Within 15 cm and 10 degrees.
  int about = 0;                    ///< Within 50 cm and 30 degrees.
  double median_m = 0.0;            ///< Of the errors of place.
  double estimated_stddev_m = 0.0;  ///< What the particles say of it, median.
};

bool is_found(const NxtOutcome& outcome, double within_m, double within_deg) {
  const double within_rad = geometry::radians(within_deg);
  return (outcome.error_m < within_m && outcome.heading_error_rad < within_rad) ||
         (outcome.twin_error_m < within_m && outcome.twin_heading_error_rad < within_rad);
}

NxtRates nxt_rates_of(const std::string& name, const NxtTrial& trial) {
  const world::FloorPlan room = tests::bundled_room("empty_room");
  const auto cloud_m = nxt_cloud(room, 1);
  NxtRates rates;
  std::vector<double> errors_m;
  std::vector<double> stds_m;
  for (int start = 1; start <= kStarts; ++start) {
    const NxtOutcome outcome =
        localize_nxt(room, cloud_m, trial, static_cast<std::uint32_t>(start));
    rates.right += is_found(outcome, 0.15, 10.0) ? 1 : 0;
    rates.about += is_found(outcome, 0.5, 30.0) ? 1 : 0;
    errors_m.push_back(std::min(outcome.error_m, outcome.twin_error_m));
    stds_m.push_back(outcome.stddev_m);
  }
  std::sort(errors_m.begin(), errors_m.end());
  std::sort(stds_m.begin(), stds_m.end());
  rates.median_m = errors_m[kStarts / 2];
  rates.estimated_stddev_m = stds_m[kStarts / 2];
  std::cout << name << ": right " << rates.right << ", about " << rates.about << " of " << kStarts
            << ", median error " << rates.median_m << " m, believed " << rates.estimated_stddev_m
            << " m\n";
  return rates;
}

const NxtRates& as_told() {
  static const NxtRates rates = nxt_rates_of("250 particles, drawn after eight readings", {});
  return rates;
}

TEST(Paper000Localization, FindsAboutWhereTheRobotIs) {
  EXPECT_GE(as_told().about, 0.55 * kStarts);
  EXPECT_LT(as_told().median_m, 0.35);
  // No particle was nearer, and none comes nearer by noise of half a millimetre.
  EXPECT_LE(as_told().right, 0.35 * kStarts);
}

TEST(Paper000Localization, IsSurerThanItIsRight) {
  EXPECT_LT(as_told().estimated_stddev_m, 0.05 * as_told().median_m);
}

TEST(Paper000Localization, IsWorseAsItsAlgorithmIsPrinted) {
  const NxtRates printed = nxt_rates_of("250 particles, drawn after each reading",
                                        {.resamples_after_each_reading = true});
  EXPECT_LT(printed.about, as_told().about - 10);
}

TEST(Paper000Localization, FindsTheRobotWhereWhatIsDrawnIsSpread) {
  const NxtRates spread = nxt_rates_of("250 particles, spread by 3 cm and 3 degrees",
                                       {.spread_m = 0.03, .spread_rad = 0.05});
  EXPECT_GE(spread.right, 0.5 * kStarts);
  EXPECT_GT(spread.right, as_told().right + 15);
}

TEST(Paper000Localization, MoreParticlesAloneHelpLess) {
  const NxtRates more = nxt_rates_of("1,000 particles", {.particles = 1000});
  EXPECT_GT(more.about, as_told().about);
  EXPECT_LT(more.right, 0.5 * kStarts);
}

}  // namespace
}  // namespace echomap::papers
