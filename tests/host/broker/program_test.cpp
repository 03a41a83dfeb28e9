// SPDX-License-Identifier: MIT
#include "host/broker/program.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::broker {
namespace {

using console::CommandError;
using testing::AllOf;
using testing::HasSubstr;

class ProgramTest : public testing::Test {
 protected:
  tests::ScratchFolder folder_;
};

TEST_F(ProgramTest, IsFoundInPathAndWhereSystemProgramsAre) {
  const auto file = folder_ / "tool";
  std::ofstream(file) << "#!/bin/sh\n";
  EXPECT_THROW(find_program({"tool", "tools"}, folder_.path().string()), CommandError)
      << "it cannot be run";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  EXPECT_EQ(find_program({"tool", "tools"}, "/nowhere:" + folder_.path().string()), file);
  EXPECT_EQ(find_program({"mosquitto", "mosquitto"}, "/nowhere").filename(), "mosquitto");
}

TEST_F(ProgramTest, OneThatIsMissingNamesItsPackage) {
  EXPECT_THAT(tests::thrown_text<CommandError>([] {
                find_program({"no-such-broker", "some-package"}, "/usr/bin");
              }),
              AllOf(HasSubstr("no-such-broker is not installed"),
                    HasSubstr("next: sudo apt-get install some-package")));
}

TEST_F(ProgramTest, AFailureSaysItsLastLine) {
  const auto log = folder_ / "log";
  EXPECT_NO_THROW(run_program({"/bin/sh", "-c", "exit 0"}, "do it", log));
  EXPECT_THAT(tests::thrown_text<CommandError>([&] {
                run_program({"/bin/sh", "-c", "echo first; echo why; echo; exit 3"}, "do it", log);
              }),
              HasSubstr("could not do it (exit code 3): why"));
}

}  // namespace
}  // namespace echomap::broker
