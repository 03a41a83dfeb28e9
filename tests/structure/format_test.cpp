// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/structure/shell.hpp"

namespace echomap::structure {
namespace {

TEST(Format, EverySourceIsLaidOut) {
  if (!has_program("clang-format-16")) {
    GTEST_SKIP() << "clang-format-16 is not installed";
  }
  const ShellResult result = run_shell("./run fmt --check", ECHOMAP_SOURCE_DIR);
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST(Format, TheShellScriptsPassShellcheck) {
  if (!has_program("shellcheck")) {
    GTEST_SKIP() << "shellcheck is not installed";
  }
  const ShellResult result = run_shell("shellcheck run .ci/run", ECHOMAP_SOURCE_DIR);
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

}  // namespace
}  // namespace echomap::structure
