// SPDX-License-Identifier: MIT
#include "tests/ports/replugs.hpp"

#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

TEST(Replugs, AreSurvivedUnderAnotherName) { EXPECT_EQ(measure_survived_replugs(4), 4); }

}  // namespace
}  // namespace echomap::tests
