// SPDX-License-Identifier: MIT
#include "host/localization/round_fit.hpp"

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(RoundFit, ContradictsWhereRoundsAgreeBadlyForLong) {
  RoundFit fit;
  EXPECT_FALSE(fit.contradicts()) << "nothing was said";
  for (int i = 0; i < 200; ++i) {
    fit.add(-0.75);
  }
  fit.add(-3.0);
  EXPECT_FALSE(fit.contradicts()) << "of one bad round";
  for (int i = 0; i < 200; ++i) {
    fit.add(-1.0);
  }
  EXPECT_TRUE(fit.contradicts());
}

TEST(RoundFit, ForgetsWhenItIsRestarted) {
  RoundFit fit;
  fit.add(-2.0);
  ASSERT_TRUE(fit.contradicts());
  fit.restart();
  EXPECT_FALSE(fit.contradicts());
}

}  // namespace
}  // namespace echomap::localization
