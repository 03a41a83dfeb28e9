// SPDX-License-Identifier: MIT
#include "protocol/version.hpp"

#include <gtest/gtest.h>

namespace echomap::protocol {
namespace {

TEST(Version, OfTheFirmwareIsThatOfTheProject) {
  EXPECT_STREQ(VersionText(kFirmwareVersion).text(), ECHOMAP_VERSION);
}

TEST(Version, HasThreeNumbers) {
  EXPECT_STREQ(VersionText(0).text(), "0.0.0");
  EXPECT_STREQ(VersionText(7).text(), "0.0.7");
  EXPECT_STREQ(VersionText(123).text(), "1.2.3");
  EXPECT_STREQ(VersionText(1020).text(), "10.2.0");
  EXPECT_STREQ(VersionText(UINT16_MAX).text(), "655.3.5");
}

}  // namespace
}  // namespace echomap::protocol
