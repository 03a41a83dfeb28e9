// SPDX-License-Identifier: MIT
#include "host/apps/port_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/udev_rules.hpp"
#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

TEST(PortOptions, AreInTheHelp) {
  const Said help = run({"ports", "--help"});
  EXPECT_EQ(help.code, console::ExitCode::kOk);
  for (const char* option : {"--json", "--forget", "--forget-all", "--print-rules"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
}

TEST(PortOptions, PrintTheRulesOnStdout) {
  EXPECT_EQ(run({"ports", "--print-rules"}).out, transport::udev_rules());
}

TEST(PortOptions, ExcludeWhatContradicts) {
  EXPECT_EQ(run({"ports", "--print-rules", "--install-rules"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"ports", "--forget", "a", "--forget-all"}).code, console::ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
