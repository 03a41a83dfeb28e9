// SPDX-License-Identifier: MIT
#include "host/apps/map_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

TEST(MapOptions, EvalWantsSomethingToCompareWith) {
  EXPECT_EQ(run({"eval", "."}).code, console::ExitCode::kUsage);
  EXPECT_THAT(run({"eval", "."}).err, HasSubstr("--truth or --relations"));
  EXPECT_EQ(run({"eval", ".", "--picture", "a.png", "--relations", "/dev/null"}).code,
            console::ExitCode::kUsage);
  EXPECT_EQ(run({"diff", "no_such_folder", "."}).code, console::ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
