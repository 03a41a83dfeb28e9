// SPDX-License-Identifier: MIT
#include "host/apps/fleet_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

TEST(FleetOptions, AreInTheHelp) {
  const Said group = run({"fleet", "--help"});
  EXPECT_EQ(group.code, console::ExitCode::kOk);
  EXPECT_THAT(group.out, HasSubstr("replay"));
  const Said help = run({"fleet", "replay", "--help"});
  for (const char* option : {"folder", "--blind", "--out", "--force", "--json", "--headless"}) {
    EXPECT_THAT(help.out, HasSubstr(option));
  }
}

TEST(FleetOptions, AnUnknownSubCommandIsNamedWithTheOneThatWasMeant) {
  const Said said = run({"fleet", "repaly", "folder"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("unknown command 'repaly'"));
  EXPECT_THAT(said.err, HasSubstr("replay"));
  EXPECT_THAT(said.err, HasSubstr("next: echomap fleet --help"));
}

TEST(FleetOptions, AMissingSubCommandOrFolderSaysWhereHelpIs) {
  EXPECT_EQ(run({"fleet"}).code, console::ExitCode::kUsage);
  EXPECT_THAT(run({"fleet"}).err, HasSubstr("next: echomap fleet --help"));
  const Said said = run({"fleet", "replay", "/no/such/folder"});
  EXPECT_EQ(said.code, console::ExitCode::kUsage);
  EXPECT_THAT(said.err, HasSubstr("next: echomap fleet replay --help"));
}

}  // namespace
}  // namespace echomap::apps
