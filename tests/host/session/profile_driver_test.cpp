// SPDX-License-Identifier: MIT
#include "host/session/profile_driver.hpp"

#include <string>

#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"

namespace echomap::session {
namespace {

TEST(ProfileDriver, IsWrittenIntoTheTableOfTheDrive) {
  EXPECT_EQ(with_driver("name = \"mine\"\n[drive]  # wheels\ntrack_m = 0.1\n[body]\nradius_m = 1\n",
                        "l298n"),
            "name = \"mine\"\n[drive]  # wheels\ndriver = \"l298n\"\ntrack_m = 0.1\n[body]\n"
            "radius_m = 1\n");
}

TEST(ProfileDriver, TakesThePlaceOfAnotherOne) {
  EXPECT_EQ(with_driver("[drive]\ntrack_m = 0.1\n  driver = \"drv8833\"\n", "tb6612fng"),
            "[drive]\ndriver = \"tb6612fng\"\ntrack_m = 0.1\n");
  EXPECT_EQ(with_driver("[odometry]\ndriver = \"drv8833\"\n[drive]\n", "tb6612fng"),
            "[odometry]\ndriver = \"drv8833\"\n[drive]\ndriver = \"tb6612fng\"\n")
      << "a key of another table";
}

TEST(ProfileDriver, IsNotLeftOutWithoutAWord) {
  EXPECT_THROW(with_driver("drive.track_m = 0.1\n", "l298n"), console::CommandError);
  EXPECT_THROW(with_driver("[odometry]\n", "l298n"), console::CommandError);
}

TEST(ProfileDriver, IsReadBack) {
  EXPECT_EQ(driver_of(with_driver("[drive]\ntrack_m = 0.1\n", "servo")), "servo");
  EXPECT_EQ(driver_of("[drive]\ntrack_m = 0.1\n"), "");
  EXPECT_EQ(driver_of("name = \"mine\"\n"), "");
}

}  // namespace
}  // namespace echomap::session
