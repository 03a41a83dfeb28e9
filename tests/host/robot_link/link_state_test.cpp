// SPDX-License-Identifier: MIT
#include "host/robot_link/link_state.hpp"

#include <set>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

TEST(LinkState, HasANameOfItsOwnForEach) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(LinkState::kLost); ++i) {
    names.insert(to_string(static_cast<LinkState>(i)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(LinkState::kLost) + 1);
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace echomap::robot_link
