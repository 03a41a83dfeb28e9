// SPDX-License-Identifier: MIT
#include "host/source_search/source_estimate.hpp"

#include <gtest/gtest.h>

namespace echomap::source_search {
namespace {

TEST(SourceEstimate, VerdictsHaveNames) {
  EXPECT_STREQ(name_of(SourceVerdict::kUndecided), "undecided");
  EXPECT_STREQ(name_of(SourceVerdict::kFound), "found");
  EXPECT_STREQ(name_of(SourceVerdict::kNone), "none");
}

TEST(SourceEstimate, IsUndecidedAtFirst) {
  EXPECT_EQ(SourceEstimate{}.verdict, SourceVerdict::kUndecided);
}

}  // namespace
}  // namespace echomap::source_search
