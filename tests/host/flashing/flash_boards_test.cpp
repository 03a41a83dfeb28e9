// SPDX-License-Identifier: MIT
#include "host/flashing/flash_boards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/transport/usb_table.hpp"

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

TEST(KnownUsbIds, NameBoardsThatThereAre) {
  for (const transport::KnownUsbId& known : transport::known_usb_ids()) {
    if (!known.board.empty()) {
      EXPECT_EQ(flash_board(known.board).name, known.board);
    }
  }
}

TEST(KnownUsbIds, StandInTheGuide) {
  const std::string guide = files::read_text_file(ECHOMAP_SOURCE_DIR "/docs/guides/flashing.md");
  for (const transport::KnownUsbId& known : transport::known_usb_ids()) {
    EXPECT_THAT(guide, testing::HasSubstr(to_string(known.id)));
  }
}

}  // namespace
}  // namespace echomap::flashing
