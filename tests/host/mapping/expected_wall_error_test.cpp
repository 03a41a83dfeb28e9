// SPDX-License-Identifier: MIT
#include "host/mapping/expected_wall_error.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/drawn_map.hpp"

namespace echomap::mapping {
namespace {

RasterMap wall_at(double x_m) { return tests::map_from({"#", "#"}, 0.1, {x_m - 0.05, -0.1}); }

TEST(ExpectedWallError, GrowsWithTheDoubtAboutTheHeadingAndTheDistance) {
  const auto near = expected_wall_error(wall_at(1.0), 0.05);
  const auto far = expected_wall_error(wall_at(8.0), 0.05);
  const auto sure = expected_wall_error(wall_at(8.0), 1e-4);
  ASSERT_TRUE(near && far && sure);
  EXPECT_GT(far->median_m, 2.0 * near->median_m);
  EXPECT_LT(sure->median_m, near->median_m);
  EXPECT_GT(near->p90_m, near->median_m);
  EXPECT_NEAR(far->median_m, std::hypot(0.03, 0.25 * 0.05 * 8.0), 0.001);
}

TEST(ExpectedWallError, IsNothingWithoutWallsOrWithoutADeviation) {
  for (const double stddev_rad : {0.0, -0.1, std::nan("")}) {
    EXPECT_FALSE(expected_wall_error(wall_at(1.0), stddev_rad));
  }
  EXPECT_FALSE(expected_wall_error(tests::map_from({"..", " ."}, 0.1), 0.05));
}

}  // namespace
}  // namespace echomap::mapping
