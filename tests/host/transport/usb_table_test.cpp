// SPDX-License-Identifier: MIT
#include "host/transport/usb_table.hpp"

#include <set>

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(UsbTable, HasEachIdOnceAndABoardForThoseOfOneBoard) {
  std::set<UsbId> seen;
  for (const KnownUsbId& known : known_usb_ids()) {
    EXPECT_TRUE(seen.insert(known.id).second) << to_string(known.id);
    EXPECT_EQ(known.role == UsbRole::kBoard, !known.board.empty()) << to_string(known.id);
  }
}

TEST(UsbTable, SaysWhatIsABoardAndWhatOnlyItsSerialChip) {
  EXPECT_EQ(known_usb_id({0x2341, 0x0043})->board, "uno");
  EXPECT_EQ(known_usb_id({0x2a03, 0x0042})->board, "mega");
  EXPECT_EQ(known_usb_id({0x1a86, 0x7523})->role, UsbRole::kSerialChip);
  EXPECT_EQ(known_usb_id({0x0483, 0x3748})->role, UsbRole::kProgrammer);
  // A modem, and an ST-Link soldered to another board.
  EXPECT_EQ(known_usb_id({0x12d1, 0x1506}), nullptr);
  EXPECT_EQ(known_usb_id({0x0483, 0x374b}), nullptr);
}

TEST(UsbTable, TakesNoModemProgrammerOrDriveForARobot) {
  EXPECT_TRUE(may_be_robot({0x2341, 0x0043}));
  EXPECT_TRUE(may_be_robot({0x1a86, 0x55d4}));
  EXPECT_TRUE(may_be_robot({0x2e8a, 0x000a}));
  EXPECT_TRUE(may_be_robot({0x0525, 0xa4a7})) << "an EV3's serial gadget";
  EXPECT_TRUE(may_be_robot({0x0694, 0x0005})) << "an EV3";
  EXPECT_FALSE(may_be_robot({0x2e8a, 0x0003})) << "a boot drive";
  EXPECT_FALSE(may_be_robot({0x0483, 0x3748})) << "an ST-Link";
  EXPECT_FALSE(may_be_robot({0x12d1, 0x1506})) << "a modem";
}

}  // namespace
}  // namespace echomap::transport
