// SPDX-License-Identifier: MIT
#include "tests/benchmarks/measured_boards.hpp"

#include <fstream>
#include <stdexcept>

#include <gmock/gmock.h>

#include "host/session/temporary_folder.hpp"

namespace echomap::bench {
namespace {

TEST(MeasuredBoards, AreAllOrThoseThatAreNamed) {
  EXPECT_EQ(boards_named({"all"}).size(), 5U);
  const auto named = boards_named({"ev3", "uno"});
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0].name, "ev3");
  EXPECT_EQ(named[1].image, "echomap-uno");
}

TEST(MeasuredBoards, RefusesANameThatNoneHas) {
  EXPECT_THROW(boards_named({"uno", "due"}), std::invalid_argument);
}

TEST(MeasuredBoards, NamesTheImageThatIsNotBuiltThenTheProgram) {
  const session::TemporaryFolder folder;
  const BuildFolders build{folder.path(), folder.path()};
  const MeasuredBoard pico = measured_board("pico");
  EXPECT_EQ(missing_of(pico, pico.program, build), "echomap-pico.elf");
  std::ofstream(folder / "echomap-pico.elf") << "";
  EXPECT_EQ(missing_of(pico, pico.program, build), "echomap-rp2040");
  std::ofstream(folder / "echomap-rp2040") << "";
  EXPECT_EQ(missing_of(pico, pico.program, build), "");
}

}  // namespace
}  // namespace echomap::bench
