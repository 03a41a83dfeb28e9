// SPDX-License-Identifier: MIT
#include "host/optimization/robust_kernel.hpp"

#include <gtest/gtest.h>

namespace echomap::optimization {
namespace {

TEST(RobustKernel, AResidualWithoutErrorCountsInFull) {
  EXPECT_EQ(inlier_share(0.0, 3.0), 1.0);
  EXPECT_EQ(geman_mcclure_weight(0.0, 3.0), 1.0);
}

TEST(RobustKernel, AtTheKernelsWidthHalfOfAResidualIsInlier) {
  EXPECT_DOUBLE_EQ(inlier_share(9.0, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(geman_mcclure_weight(9.0, 3.0), 0.25);
}

/// The weight is the derivative of the cost by the squared error (Triggs et al. 1999).
TEST(RobustKernel, TheWeightOfGemanAndMcClureIsTheDerivativeOfTheirCost) {
  constexpr double kKernel = 2.0;
  constexpr double kStep = 1e-6;
  const auto cost = [](double square) { return square * inlier_share(square, kKernel); };
  for (const double square : {0.0, 0.5, 4.0, 30.0}) {
    EXPECT_NEAR(
        (cost(square + kStep) - cost(square)) / kStep, geman_mcclure_weight(square, kKernel), 1e-5);
  }
}

}  // namespace
}  // namespace echomap::optimization
