// SPDX-License-Identifier: MIT
#include "host/flashing/flash_boards.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::flashing {
namespace {

TEST(FlashBoards, AreFoundByName) {
  EXPECT_EQ(flash_board("mega").part, "m2560");
  EXPECT_EQ(flash_board("nano").bauds, (std::vector<int>{115200, 57600}));
  for (const std::string& name : flash_board_names()) {
    EXPECT_EQ(flash_board(name).name, name);
  }
}

TEST(FlashBoards, OfAnotherNameAreAUsageError) {
  try {
    flash_board("nanno");
    FAIL() << "no error";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kUsage);
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'nano'"));
  }
}

TEST(KnownUsbIds, StandOnceEachAndNameABoardThatThereIs) {
  std::set<transport::UsbId> seen;
  for (const KnownUsbId& known : known_usb_ids()) {
    EXPECT_TRUE(seen.insert(known.id).second) << to_string(known.id);
    EXPECT_EQ(known.role == UsbRole::kBoard, !known.board.empty()) << to_string(known.id);
    if (!known.board.empty()) {
      EXPECT_EQ(flash_board(known.board).name, known.board);
    }
  }
}

TEST(KnownUsbIds, SayWhatIsABoardAndWhatOnlyItsSerialChip) {
  EXPECT_EQ(known_usb_id({0x2341, 0x0043})->board, "uno");
  EXPECT_EQ(known_usb_id({0x2a03, 0x0042})->board, "mega");
  EXPECT_EQ(known_usb_id({0x1a86, 0x7523})->role, UsbRole::kSerialChip);
  EXPECT_EQ(known_usb_id({0x0483, 0x3748})->role, UsbRole::kProgrammer);
  // A modem, and an ST-Link soldered to another board.
  EXPECT_EQ(known_usb_id({0x12d1, 0x1506}), nullptr);
  EXPECT_EQ(known_usb_id({0x0483, 0x374b}), nullptr);
}

TEST(KnownUsbIds, StandInTheGuide) {
  const std::string guide = files::read_text_file(ECHOMAP_SOURCE_DIR "/docs/guides/flashing.md");
  for (const KnownUsbId& known : known_usb_ids()) {
    EXPECT_THAT(guide, testing::HasSubstr(to_string(known.id)));
  }
}

}  // namespace
}  // namespace echomap::flashing
