// SPDX-License-Identifier: MIT
#include "tests/ports/hijacks.hpp"

#include <gtest/gtest.h>

namespace echomap::tests {
namespace {

TEST(Hijacks, AreRefused) { EXPECT_EQ(measure_refused_hijacks(10), 10); }

}  // namespace
}  // namespace echomap::tests
