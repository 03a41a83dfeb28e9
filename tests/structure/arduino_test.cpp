// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/shell.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"
#include "tests/support/scratch_folder.hpp"

// PlatformIO and the Arduino IDE have lists and flags of their own. Neither program is needed here:
// the tests read the lists, and compile what they would compile with the flags they would give.
namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using Paths = std::set<std::string>;

/// The .cpp files below `folder`, relative to `root`.
Paths sources_below(const fs::path& root, const std::string& folder) {
  Paths paths;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    if (entry.path().extension() == ".cpp") {
      paths.insert(entry.path().lexically_relative(root).generic_string());
    }
  }
  return paths;
}

/// The words of set(NAME ..) in firmware/sources.cmake, each with `prefix`.
Paths listed_in_cmake(const std::string& name, const std::string& prefix) {
  std::string text;
  for (const std::string& line : read_lines(tree_root / "firmware/sources.cmake")) {
    text += line + "\n";
  }
  std::smatch list;
  if (!std::regex_search(text, list, std::regex("set\\(" + name + "\\s([^)]*)\\)"))) {
    throw std::runtime_error("firmware/sources.cmake has no " + name);
  }
  Paths paths;
  std::istringstream words(list[1]);
  for (std::string word; words >> word;) {
    paths.insert(prefix + word);
  }
  return paths;
}

/// What CMake compiles for an Arduino board.
Paths sources_of(const std::string& board) {
  Paths paths{"firmware/app/main.cpp"};
  paths.merge(listed_in_cmake("ECHOMAP_FIRMWARE_SOURCES", "firmware/"));
  paths.merge(listed_in_cmake("ECHOMAP_PROTOCOL_SOURCES", "protocol/"));
  paths.merge(sources_below(tree_root, "firmware/boards/avr_common"));
  paths.merge(sources_below(tree_root, "firmware/boards/edge_counter"));
  paths.merge(sources_below(tree_root, "firmware/boards/no_own_sensors"));
  paths.merge(sources_below(tree_root, "firmware/boards/arduino_" + board));
  return paths;
}

/// The sections of platformio.ini: section, key, value on one line, with ${section.key} put in.
class Ini {
 public:
  explicit Ini(const fs::path& file) {
    static const std::regex header(R"(\[(.+)\])");
    static const std::regex entry(R"((\w+) *= *(.*))");
    std::string section;
    std::string key;
    for (const std::string& line : read_lines(file)) {
      std::smatch match;
      if (std::regex_match(line, match, header)) {
        section = match[1];
      } else if (std::regex_match(line, match, entry)) {
        key = match[1];
        values_[section][key] = match[2];
      } else if (line.rfind("  ", 0) == 0) {
        values_[section][key] += " " + line;
      }
    }
  }
  /// An environment's value, or that of [env], which every environment inherits.
  std::string value(const std::string& section, const std::string& key) const {
    const auto& entries = values_.at(section);
    const auto found = entries.find(key);
    return filled(found != entries.end() ? found->second : values_.at("env").at(key));
  }
  bool has(const std::string& section) const { return values_.count(section) > 0; }

 private:
  std::string filled(std::string text) const {
    static const std::regex reference(R"(\$\{([^}]+)\.(\w+)\})");
    for (std::smatch match; std::regex_search(text, match, reference);) {
      text = match.prefix().str() + value(match[1], match[2]) + match.suffix().str();
    }
    return text;
  }

  std::map<std::string, std::map<std::string, std::string>> values_;
};

/// The sources that an environment's build_src_filter lets through.
Paths filtered(const Ini& ini, const std::string& environment) {
  Paths paths;
  std::istringstream words(ini.value(environment, "build_src_filter"));
  for (std::string word; words >> word;) {
    if (word == "-<*>") {
      paths.clear();
    } else {
      paths.merge(sources_below(tree_root, word.substr(2, word.size() - 4)));
    }
  }
  return paths;
}

std::string in_one_line(const Paths& paths) {
  std::string line;
  for (const std::string& path : paths) {
    line += shell_quoted(path) + " ";
  }
  return line;
}

/// A chip as avr-g++ names it, and what its board's image may take, in bytes of flash.
struct Chip {
  std::string name;
  int flash_bytes = 0;
};
const std::map<std::string, Chip> chips{
    {"uno", {"atmega328p", 30720}},  // What the old boot loader of a Nano leaves.
    {"mega", {"atmega2560", 253952}},
};

/// Compiles and links for a board, and expects the image to fit.
void expect_fitting(const std::string& board,
                    const std::string& flags,
                    const Paths& sources,
                    const fs::path& folder) {
  const Chip& chip = chips.at(board);
  const tests::ScratchFolder out;
  const std::string elf = shell_quoted((out / "program.elf").string());
  const ShellResult result = run_shell(
      "avr-g++ -mmcu=" + chip.name + " -DF_CPU=16000000L " + flags + " -Wl,--gc-sections " +
          in_one_line(sources) + "-o " + elf + "\navr-size " + elf + " | awk 'END {print $1 + $2}'",
      folder);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_GT(std::stoi(result.output), 8000) << "a program without its parts";
  EXPECT_LE(std::stoi(result.output), chip.flash_bytes);
}

/// The Arduino boards that there are.
std::vector<std::string> arduino_boards() {
  std::vector<std::string> boards;
  for (const auto& entry : fs::directory_iterator(tree_root / "firmware/boards")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("arduino_", 0) == 0) {
      boards.push_back(name.substr(8));
    }
  }
  return boards;
}

TEST(PlatformIo, CompilesWhatCmakeCompiles) {
  const Ini ini(tree_root / "firmware/platformio.ini");
  for (const std::string& board : arduino_boards()) {
    ASSERT_TRUE(ini.has("env:" + board)) << "platformio.ini has no [env:" << board << "]";
    EXPECT_EQ(filtered(ini, "env:" + board), sources_of(board));
  }
  EXPECT_EQ(filtered(ini, "env:nano"), sources_of("uno"));
  EXPECT_EQ(filtered(ini, "env:nano_old"), sources_of("uno"));
}

TEST(PlatformIo, HasFlagsThatCompile) {
  if (!has_program("avr-g++")) {
    GTEST_SKIP() << "avr-g++ is not installed";
  }
  const Ini ini(tree_root / "firmware/platformio.ini");
  // Those of platform-atmelavr without a framework, before ours.
  const std::string platform = "-Os -flto -ffunction-sections -fdata-sections -fno-exceptions ";
  for (const std::string& board : arduino_boards()) {
    Paths sources;
    for (const std::string& path : filtered(ini, "env:" + board)) {
      sources.insert("../" + path);
    }
    expect_fitting(board,
                   platform + ini.value("env:" + board, "build_flags"),
                   sources,
                   tree_root / "firmware");
  }
}

class ArduinoLibrary : public testing::Test {
 protected:
  /// Packs the library of a board; its folder.
  fs::path library_of(const std::string& board) {
    const ShellResult result =
        run_shell("cmake -DBOARD=" + board + " -DVERSION=1.2.3 -DOUT=" +
                      shell_quoted(folder_.path().string()) + " -P firmware/arduino/package.cmake",
                  tree_root);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return folder_ / ("echomap_" + board);
  }

  const tests::ScratchFolder folder_;
};

TEST_F(ArduinoLibrary, HoldsTheSourcesThatCmakeCompiles) {
  for (const std::string& board : arduino_boards()) {
    Paths expected;
    for (const std::string& path : sources_of(board)) {
      expected.insert("src/" + path);
    }
    const fs::path library = library_of(board);
    EXPECT_EQ(sources_below(library, "src"), expected);
    EXPECT_TRUE(fs::exists(library.string() + ".zip"));
    EXPECT_THAT(read_lines(library / "library.properties"),
                testing::IsSupersetOf({"name=echomap_" + board,
                                       std::string("version=1.2.3"),
                                       std::string("architectures=avr")}));
  }
}

TEST_F(ArduinoLibrary, CompilesWithTheFlagsOfTheArduinoCore) {
  if (!has_program("avr-g++")) {
    GTEST_SKIP() << "avr-g++ is not installed";
  }
  // compiler.cpp.flags of ArduinoCore-avr 1.8.7, then the one that docs/guides/flashing.md adds.
  const std::string flags =
      "-g -Os -w -std=gnu++11 -fpermissive -fno-exceptions -ffunction-sections -fdata-sections "
      "-fno-threadsafe-statics -Wno-error=narrowing -flto -fuse-linker-plugin -DARDUINO=10819 "
      "-DARDUINO_ARCH_AVR -std=gnu++14 -I src";
  for (const std::string& board : arduino_boards()) {
    const fs::path library = library_of(board);
    expect_fitting(board, flags, sources_below(library, "src"), library);
  }
}

TEST(FlashTargets, AreThereForTheBoardsThatAreBuilt) {
  const fs::path build = ECHOMAP_BINARY_DIR;
  if (!fs::exists(build / "build.ninja") || !has_program("avr-g++")) {
    GTEST_SKIP() << "not built by ninja, or no avr-g++";
  }
  const ShellResult result = run_shell("ninja -t commands flash_nano | tail -n 1", build);
  EXPECT_THAT(result.output, testing::HasSubstr("bin/echomap flash --board nano\n"));
}

}  // namespace
}  // namespace echomap::structure
