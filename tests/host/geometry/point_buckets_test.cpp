// SPDX-License-Identifier: MIT
#include "host/geometry/point_buckets.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<int> near(const PointBuckets<int>& buckets, const Eigen::Vector2d& point_m) {
  std::set<int> found;
  buckets.visit_near(point_m, [&](int value) { found.insert(value); });
  return found;
}

TEST(PointBuckets, FindWhatIsWithinTheirEdge) {
  PointBuckets<int> buckets(0.5);
  buckets.add({-0.1, 0.2}, 1);
  buckets.add({0.3, 0.4}, 2);
  buckets.add({0.31, 0.4}, 3);
  EXPECT_THAT(near(buckets, {0.1, 0.1}), ElementsAre(1, 2, 3));
  EXPECT_THAT(near(buckets, {0.1, -0.05}), ElementsAre(1, 2, 3));
}

TEST(PointBuckets, DoNotVisitWhatIsFarAway) {
  PointBuckets<int> buckets(0.5);
  buckets.add({0.1, 0.1}, 1);
  EXPECT_THAT(near(buckets, {1.1, 0.1}), IsEmpty());
  EXPECT_THAT(near(buckets, {0.1, -1.1}), IsEmpty());
}

TEST(SquareKey, TellsSquaresApartOnEitherSideOfTheOrigin) {
  std::set<std::int64_t> keys;
  for (const double x_m : {-0.6, -0.1, 0.1, 0.6}) {
    for (const double y_m : {-0.6, -0.1, 0.1, 0.6}) {
      keys.insert(square_key({x_m, y_m}, 0.5));
    }
  }
  EXPECT_EQ(keys.size(), 16U);
  EXPECT_EQ(square_key({0.1, 0.1}, 0.5, 1, -1), square_key({0.6, -0.1}, 0.5));
}

}  // namespace
}  // namespace echomap::geometry
