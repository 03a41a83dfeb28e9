// SPDX-License-Identifier: MIT
#include "host/transport/udev_rules.hpp"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(UdevRules, KeepModemManagerOffBoardsAndOffNothingElse) {
  const std::string rules = udev_rules();
  EXPECT_THAT(rules,
              HasSubstr("ATTR{idVendor}==\"1a86\", ATTR{idProduct}==\"7523\", "
                        "ENV{ID_MM_DEVICE_IGNORE}=\"1\"\n"));
  EXPECT_THAT(rules,
              HasSubstr("ATTRS{idVendor}==\"2341\", ATTRS{idProduct}==\"0043\", "
                        "ENV{ID_MM_PORT_IGNORE}=\"1\", GROUP=\"dialout\", MODE=\"0660\", "
                        "TAG+=\"uaccess\", SYMLINK+=\"echomap-%b\"\n"));
  EXPECT_THAT(rules, Not(HasSubstr("3748"))) << "an ST-Link has no port";
}

/// A rule without a match would be for every device of the machine.
TEST(UdevRules, AreForDevicesThatMatch) {
  std::istringstream lines(udev_rules());
  for (std::string line; std::getline(lines, line);) {
    const bool is_action = line.find("ENV{ID_MM") != std::string::npos;
    EXPECT_EQ(is_action, line.starts_with("ATTR")) << line;
  }
}

TEST(UdevRules, AreReadBeforeModemManagerChooses) {
  EXPECT_LT(std::string(kUdevRulesName), "73-seat-late.rules");
  EXPECT_LT(std::string(kUdevRulesName), "77-mm-usb-device-blacklist.rules");
}

}  // namespace
}  // namespace echomap::transport
