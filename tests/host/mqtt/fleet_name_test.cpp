// SPDX-License-Identifier: MIT
#include "host/mqtt/fleet_name.hpp"

#include <string>

#include <gtest/gtest.h>

namespace echomap::mqtt {
namespace {

TEST(FleetName, IsOneLevelOfATopic) {
  EXPECT_TRUE(is_fleet_name("r"));
  EXPECT_TRUE(is_fleet_name(std::string(32, 'z')));
  EXPECT_FALSE(is_fleet_name(""));
  EXPECT_FALSE(is_fleet_name(std::string(33, 'z')));
  for (int code = 0; code < 256; ++code) {
    const char character = static_cast<char>(code);
    const bool is_allowed =
        std::string("abcdefghijklmnopqrstuvwxyz0123456789_-").find(character) != std::string::npos;
    EXPECT_EQ(is_fleet_name(std::string(1, character)), is_allowed) << code;
  }
  // What + # and / do to the rights is measured in facts of Mosquitto.
  for (const char* const name :
       {"a/b", "a#", "+", "$SYS", "a b", "a\nuser hub", "%u", "\xc3\xa9"}) {
    EXPECT_FALSE(is_fleet_name(name)) << name;
  }
}

}  // namespace
}  // namespace echomap::mqtt
