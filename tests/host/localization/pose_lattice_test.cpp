// SPDX-License-Identifier: MIT
#include "host/localization/pose_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "tests/host/localization/heard_scan.hpp"
#include "tests/support/furnished_room.hpp"

namespace echomap::localization {
namespace {

TEST(PoseLattice, SurroundAPoseByHalfAStepAndAWholeOne) {
  const Particles poses = poses_around({1.0, 2.0, 3.1}, 0.2, 0.1);
  ASSERT_EQ(poses.size(), 125U);
  const auto [left, right] = std::minmax_element(poses.x_m.begin(), poses.x_m.end());
  EXPECT_NEAR(*left, 0.8, 1e-6);
  EXPECT_NEAR(*right, 1.2, 1e-6);
  EXPECT_EQ(std::count(poses.x_m.begin(), poses.x_m.end(), 1.1F), 25);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LE(std::abs(poses.heading_rad[i]), 3.1416F) << i;
  }
}

TEST(PoseLattice, AreLikeliestWhereTheScanWasMade) {
  const mapping::RasterMap room = tests::furnished_room();
  const auto model = tests::sonar_model(room);
  const geometry::Pose2 T_map_robot(2.2, 0.95, -0.3);
  model->observe(tests::heard_scan(room, T_map_robot));
  Particles poses = poses_around(T_map_robot, 0.3, 0.3);
  set_log_likelihoods(*model, poses);
  const auto most = std::max_element(poses.log_weight.begin(), poses.log_weight.end());
  EXPECT_EQ(most - poses.log_weight.begin(), 62) << "the middle";
  set_log_likelihoods(*model, poses);
  EXPECT_EQ(
      std::max_element(poses.log_weight.begin(), poses.log_weight.end()) - poses.log_weight.begin(),
      62)
      << "likelihoods do not add up";
}

}  // namespace
}  // namespace echomap::localization
