// SPDX-License-Identifier: MIT
#include "host/files/nearest_word.hpp"

#include <gtest/gtest.h>

namespace echomap::files {
namespace {

TEST(NearestWord, CountsEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("tarck", "track"), 1U);
  EXPECT_EQ(edit_distance("same", "same"), 0U);
}

TEST(NearestWord, SuggestsOnlyWhatIsNear) {
  EXPECT_EQ(suggestion("explroe", {"eval", "explore"}), "; did you mean 'explore'?");
  EXPECT_EQ(suggestion("zzzz", {"eval", "explore"}), "; valid here: eval, explore");
  EXPECT_EQ(suggestion("x", {}), "");
}

}  // namespace
}  // namespace echomap::files
