// SPDX-License-Identifier: MIT
#include "host/terminal_view/unflushed_terminal.hpp"

#include <termios.h>

#include <gtest/gtest.h>

#include "tests/host/console/terminal.hpp"

namespace echomap::terminal_view {
namespace {

bool flushes(const console::Terminal& terminal) {
  termios settings{};
  EXPECT_EQ(::tcgetattr(::fileno(terminal.file()), &settings), 0);
  return (settings.c_lflag & NOFLSH) == 0;
}

TEST(UnflushedTerminal, LeavesTheTerminalAsItWas) {
  const console::Terminal terminal;
  ASSERT_TRUE(flushes(terminal));
  {
    const UnflushedTerminal outer(::fileno(terminal.file()));
    EXPECT_FALSE(flushes(terminal));
    { const UnflushedTerminal inner(::fileno(terminal.file())); }
    EXPECT_FALSE(flushes(terminal)) << "the inner one has found it so";
  }
  EXPECT_TRUE(flushes(terminal));
}

TEST(UnflushedTerminal, DoesNothingWhereNoTerminalIs) { const UnflushedTerminal none(-1); }

}  // namespace
}  // namespace echomap::terminal_view
