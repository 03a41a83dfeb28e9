// SPDX-License-Identifier: MIT
#include "host/console/shell_line.hpp"

#include <gtest/gtest.h>

namespace echomap::console {
namespace {

TEST(ShellLine, QuotesWhatAShellWouldTakeApart) {
  EXPECT_EQ(shell_line({"a", "flash:w:x.hex:i", "b c", "it's", ""}),
            "a flash:w:x.hex:i 'b c' 'it'\\''s' ''");
}

}  // namespace
}  // namespace echomap::console
