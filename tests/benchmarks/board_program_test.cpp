// SPDX-License-Identifier: MIT
#include "tests/benchmarks/board_program.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

/// A build whose program for the Uno is this script.
class BoardProgram : public ::testing::Test {
 protected:
  void build_with(const std::string& script) {
    const auto program = folder / uno.measures;
    std::ofstream(folder / "echomap-uno.elf") << "";
    std::ofstream(program) << "#!/bin/sh\n" + script;
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }

  const session::TemporaryFolder folder;
  const BuildFolders folders{folder.path(), folder.path()};
  const MeasuredBoard uno = measured_board("uno");
};

TEST_F(BoardProgram, GivesItsFigures) {
  build_with(R"(
    [ "$1" = --board=uno ] && [ "$2" = --part=link ] || exit 3
    echo '{"notes": {"uno": "simavr 1.6"}, "figures": [
      {"name": "bump_stop_ms", "value": 0.9, "unit": "ms", "runs": 20}]}' >"${3#--json=}")");
  const BoardReport report = run_measures(uno, "link", folders);
  EXPECT_EQ(report.emulator, "simavr 1.6");
  ASSERT_EQ(report.figures.size(), 1U);
  EXPECT_EQ(report.figures[0].name, "bump_stop_ms");
}

TEST_F(BoardProgram, ThatFailsIsNamedWithWhatItSaid) {
  build_with("echo the robot does not get ready; exit 1");
  try {
    run_measures(uno, "table", folders);
    FAIL() << "a program that failed gave figures";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("measure_on_simavr failed: the robot does not"));
  }
}

TEST_F(BoardProgram, ThatIsNotBuiltIsNamed) {
  try {
    run_measures(uno, "table", folders);
    FAIL() << "nothing is built";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "uno: echomap-uno.elf is not built");
  }
}

}  // namespace
}  // namespace echomap::bench
