// SPDX-License-Identifier: MIT
#include "tests/structure/file_rules.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string spdx_line = "// SPDX-License-Identifier: MIT";

/// Sources without a test of their own, and why.
const std::vector<std::string> without_own_test{
    // Registers: tests/hil runs them on the emulated chip.
    "firmware/boards/arduino_mega",
    "firmware/boards/arduino_uno",
    "firmware/boards/avr_common",
    "firmware/boards/cortex_common",
    // The same of a whole program: guard_test.cpp there starts it, hil_mock/ev3 drives it.
    "firmware/boards/ev3/absent_parts.cpp",
    "firmware/boards/ev3/board.cpp",
    "firmware/boards/ev3/clock.cpp",
    "firmware/boards/no_own_sensors",
    "firmware/boards/rp2040",
    "firmware/boards/stm32f103",
    // Parts of one chip: tests/hil/emulated_chip_test.cpp and its neighbours run programs on it.
    "hil_mock/emulator",
    // The same for a whole chip and its board, by the release image.
    "hil_mock/unicorn/stm32_chip.cpp",
    "hil_mock/unicorn/unicorn_board.cpp",
    "hil_mock/rp2040/chip_link.cpp",
    "hil_mock/rp2040/rp2040_board.cpp",
    // Mains and commands: tests/integration starts the programs as a user does.
    "firmware/app/main.cpp",
    "hil_mock/ev3/main.cpp",
    "hil_mock/mock_device/main.cpp",
    "hil_mock/rp2040/main.cpp",
    "hil_mock/unicorn/main.cpp",
    "host/apps/characterise_command.cpp",
    "host/apps/demo_command.cpp",
    "host/apps/demo_kidnap.cpp",
    "host/apps/diff_command.cpp",
    "host/apps/echomap.cpp",
    "host/apps/eval_command.cpp",
    "host/apps/explore_command.cpp",
    "host/apps/explore_run.cpp",
    "host/apps/fleet_broker_command.cpp",
    "host/apps/fleet_connection.cpp",
    "host/apps/fleet_join_command.cpp",
    "host/apps/fleet_map_command.cpp",
    "host/apps/fleet_page.cpp",
    "host/apps/fleet_record_command.cpp",
    "host/apps/fleet_score.cpp",
    "host/apps/fleet_start_command.cpp",
    "host/apps/fleet_status_command.cpp",
    "host/apps/fleet_watch.cpp",
    "host/apps/flash_command.cpp",
    "host/apps/localize_run.cpp",
    "host/apps/paper_command.cpp",
    "host/apps/search_command.cpp",
    "host/console/interrupt.cpp",
    "host/fleet_member/fleet_member.cpp",
    "host/session/simulated_robots.cpp",
};

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = read_source_tree(ECHOMAP_SOURCE_DIR);
  return files;
}

// --- the tree as it is

TEST(FileRules, TheTreeIsRead) { EXPECT_GT(tree().size(), 50U); }

TEST(FileRules, EveryFileBeginsAsItShould) { EXPECT_THAT(first_line_problems(tree()), IsEmpty()); }

TEST(FileRules, NoFileIsTooLong) { EXPECT_THAT(length_problems(tree()), IsEmpty()); }

TEST(FileRules, EverySourceHasItsTest) {
  EXPECT_THAT(untested_source_problems(tree(), without_own_test), IsEmpty());
}

TEST(FileRules, EveryFolderNameSaysWhatItIsFor) {
  EXPECT_THAT(folder_name_problems(tree()), IsEmpty());
}

TEST(FileRules, PortableFirmwareNeedsNoStandardLibrary) {
  EXPECT_THAT(portability_problems(tree()), IsEmpty());
}

TEST(FileRules, EveryDeclarationOfAHeaderIsDocumented) {
  EXPECT_THAT(undocumented_problems(tree()), IsEmpty());
}

TEST(FileRules, NothingIsLeftForLater) { EXPECT_THAT(reminder_problems(tree()), IsEmpty()); }

// --- what each rule catches

TEST(FileRules, CatchAMissingSpdxLineOrPragma) {
  EXPECT_THAT(
      first_line_problems({{"host/a.cpp", {}},
                           {"host/b.cpp", {"#include <map>", spdx_line}},
                           {"host/c.hpp", {spdx_line, "", "#pragma once"}},
                           {"host/d.hpp", {spdx_line, "#pragma once"}}}),
      ElementsAre(HasSubstr("host/a.cpp"), HasSubstr("host/b.cpp"), HasSubstr("#pragma once")));
}

TEST(FileRules, CatchAFileOf501Lines) {
  const std::vector<std::string> longest(500, "x");
  const std::vector<std::string> too_long(501, "x");
  EXPECT_THAT(length_problems({{"host/a.cpp", longest}, {"host/b.cpp", too_long}}),
              ElementsAre("host/b.cpp: 501 lines"));
}

TEST(FileRules, CatchASourceWithoutATest) {
  const std::vector<SourceFile> files{{"host/x/y.cpp", {}},
                                      {"host/x/z.cpp", {}},
                                      {"host/x/w.hpp", {}},
                                      {"tests/host/x/y_test.cpp", {}}};
  EXPECT_THAT(untested_source_problems(files, {}), ElementsAre(HasSubstr("host/x/z.cpp")));
  EXPECT_THAT(untested_source_problems(files, {"host/x/z.cpp"}), IsEmpty());
  EXPECT_THAT(untested_source_problems(files, {"host/x"}), IsEmpty());
}

TEST(FileRules, CatchAFolderNamedCommon) {
  EXPECT_THAT(folder_name_problems({{"host/common/x.cpp", {}}, {"host/commons.cpp", {}}}),
              ElementsAre(HasSubstr("host/common/x.cpp")));
}

TEST(FileRules, CatchCppHeadersAndStdInTheFirmware) {
  const std::vector<std::string> lines{
      "#include <stdint.h>", "#include <cstdint>", "std::swap(a, b);"};
  EXPECT_THAT(
      portability_problems({{"protocol/x.cpp", lines}, {"firmware/boards/native/x.cpp", lines}}),
      ElementsAre(HasSubstr("protocol/x.cpp:2"), HasSubstr("protocol/x.cpp:3")));
}

TEST(FileRules, CatchADeclarationWithoutComment) {
  const SourceFile header{"host/x.hpp",
                          {spdx_line,
                           "#pragma once",
                           "",
                           "namespace echomap {",
                           "struct First {",
                           "",
                           "  int x;",
                           "};",
                           "",
                           "class Later;",
                           "",
                           "/// Says what it is for.",
                           "int second();",
                           "",
                           "template <class T>",
                           "T third();",
                           "",
                           "template <>",
                           "struct Special<int> {};",
                           "",
                           "inline bool operator!=(First left, First right);",
                           "}  // namespace echomap"}};
  EXPECT_THAT(undocumented_problems({header}),
              ElementsAre(HasSubstr("host/x.hpp:5"), HasSubstr("host/x.hpp:15")));
}

TEST(FileRules, CatchAReminder) {
  const std::string reminder = std::string("// TO") + "DO: later";
  EXPECT_THAT(reminder_problems({{"host/x.cpp", {spdx_line, reminder}}}),
              ElementsAre(HasSubstr("host/x.cpp:2")));
}

}  // namespace
}  // namespace echomap::structure
