// SPDX-License-Identifier: MIT
#include "host/console/print.hpp"

#include <gtest/gtest.h>

#include "host/console/progress_bar.hpp"
#include "tests/host/console/terminal.hpp"

namespace echomap::console {
namespace {

TEST(Print, MakesAProgressBarWipeItsLineFirst) {
  const Terminal terminal;
  ProgressBar bar(terminal.file());
  bar.show("4 stops");
  print("printed by a test");
  EXPECT_EQ(terminal.shown(), "\r\033[K4 stops\r\033[K");
}

}  // namespace
}  // namespace echomap::console
