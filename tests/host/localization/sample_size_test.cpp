// SPDX-License-Identifier: MIT
#include "host/localization/sample_size.hpp"

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

/// Half of the 99 % quantile of chi square, from tables, over the error.
TEST(KldSampleSize, IsTheQuantileOfChiSquare) {
  EXPECT_NEAR(static_cast<double>(kld_sample_size(11, 0.05)), 23.209 / 0.1, 3.0);
  EXPECT_NEAR(static_cast<double>(kld_sample_size(101, 0.05)), 135.807 / 0.1, 3.0);
}

TEST(KldSampleSize, NeedsOneParticleForOneBin) {
  EXPECT_EQ(kld_sample_size(0, 0.05), 1U);
  EXPECT_EQ(kld_sample_size(1, 0.05), 1U);
}

}  // namespace
}  // namespace echomap::localization
