// SPDX-License-Identifier: MIT
#include "host/localization/ekf_outcome.hpp"

#include <gtest/gtest.h>

namespace echomap::localization {
namespace {

TEST(EkfOutcome, NamesTheFaultOfAMeasurement) {
  EXPECT_EQ(outcome_of(MeasurementFault::kNotFinite), EkfOutcome::kNotFinite);
  EXPECT_EQ(outcome_of(MeasurementFault::kBadRange), EkfOutcome::kBadRange);
  EXPECT_EQ(outcome_of(MeasurementFault::kBadCovariance), EkfOutcome::kBadCovariance);
}

}  // namespace
}  // namespace echomap::localization
