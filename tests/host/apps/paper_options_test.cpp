// SPDX-License-Identifier: MIT
#include "host/apps/paper_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using testing::HasSubstr;

TEST(PaperOptions, AreInTheHelp) {
  const Said help = run({"paper", "--help"});
  EXPECT_EQ(help.code, console::ExitCode::kOk);
  for (const char* text : {"000", "--seed", "--runs", "--out", "--force", "--json", "--headless"}) {
    EXPECT_THAT(help.out, HasSubstr(text));
  }
}

TEST(PaperOptions, AnUnknownPaperIsRefusedWithThoseThatThereAre) {
  for (const char* number : {"005", "0", "epuck"}) {
    const Said said = run({"paper", number});
    EXPECT_EQ(said.code, console::ExitCode::kUsage);
    EXPECT_THAT(said.err, HasSubstr("001"));
    EXPECT_THAT(said.err, HasSubstr("next: echomap paper --help"));
  }
  EXPECT_EQ(run({"paper"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"paper", "000", "--runs", "1"}).code, console::ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
