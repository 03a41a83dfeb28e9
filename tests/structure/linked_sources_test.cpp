// SPDX-License-Identifier: MIT
#include "tests/structure/linked_sources.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/source_tree.hpp"

namespace echomap::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Files that no program links yet, and why they stay. A header is named by its source.
const std::vector<std::string> without_program{
    // The papers' experiments, which get a command of their own.
    "host/localization/landmark_matching.cpp",
    // Put first into the flash by the linker script, for the ROM.
    "firmware/boards/rp2040/boot2.cpp",
    // Read by the sanitizers' runtime, called by nobody.
    "hil_mock/emulator/leak_suppressions.cpp",
};

bool stays(const std::string& path) {
  const std::string source = path.substr(0, path.size() - 3) + "cpp";
  return std::count(without_program.begin(), without_program.end(), path) > 0 ||
         std::count(without_program.begin(), without_program.end(), source) > 0;
}

TEST(LinkedSources, EveryFileIsInAProgram) {
  std::vector<std::string> others = files_in_no_program(read_source_tree(ECHOMAP_SOURCE_DIR));
  std::erase_if(others, stays);
  EXPECT_THAT(others, IsEmpty())
      << "reaches no user: call it from a program, move it to tests/, or delete it";
}

TEST(LinkedSources, WhatStaysWithoutAProgramIsInNone) {
  const auto others = files_in_no_program(read_source_tree(ECHOMAP_SOURCE_DIR));
  for (const std::string& path : without_program) {
    EXPECT_THAT(others, testing::Contains(path)) << "take it off the list";
  }
}

TEST(LinkedSources, AHeaderBringsTheSourcesThatDefineIt) {
  const std::vector<SourceFile> files{
      {"host/apps/echomap.cpp", {"#include \"host/apps/commands.hpp\"", "int main(int argc) {"}},
      {"host/apps/commands.hpp", {}},
      {"host/apps/demo.cpp",
       {"#include \"host/apps/commands.hpp\"", "#include \"host/map/grid.hpp\""}},
      {"host/map/grid.hpp", {}},
      {"host/map/grid.cpp", {"#include \"host/map/grid.hpp\""}},
      {"host/map/kernel.hpp", {}},
      {"host/map/kernel.cpp",
       {"#include \"host/map/kernel.hpp\"", "#include \"host/map/grid.hpp\""}},
      {"tests/bench.cpp", {"#include \"host/map/kernel.hpp\"", "int main() {"}}};
  EXPECT_THAT(files_in_no_program(files),
              ElementsAre("host/map/kernel.hpp", "host/map/kernel.cpp"));
}

}  // namespace
}  // namespace echomap::structure
