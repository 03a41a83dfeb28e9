// SPDX-License-Identifier: MIT
#include <filesystem>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/layer_table.hpp"
#include "tests/structure/source_tree.hpp"

namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// A CMakeLists.txt.
struct Makefile {
  std::string folder;
  std::string text;
};

/// Folders with a library, and the folders whose libraries theirs name as DEPENDS.
using Links = std::map<std::string, std::set<std::string>>;

/// The words of each echomap_library(..) in a CMakeLists.txt.
std::vector<std::vector<std::string>> libraries_in(const std::string& text) {
  static const std::regex comment("#[^\n]*");
  static const std::regex call(R"(echomap_library\((\w+\s[^)]*)\))");
  const std::string code = std::regex_replace(text, comment, "");
  std::vector<std::vector<std::string>> libraries;
  for (std::sregex_iterator at(code.begin(), code.end(), call), end; at != end; ++at) {
    std::istringstream words((*at)[1]);
    libraries.emplace_back(std::istream_iterator<std::string>(words),
                           std::istream_iterator<std::string>());
  }
  return libraries;
}

Links links_of(const std::vector<Makefile>& makefiles) {
  std::map<std::string, std::string> folder_of_library;
  for (const Makefile& makefile : makefiles) {
    for (const auto& words : libraries_in(makefile.text)) {
      folder_of_library[words[0]] = makefile.folder;
    }
  }
  Links links;
  for (const Makefile& makefile : makefiles) {
    for (const auto& words : libraries_in(makefile.text)) {
      std::set<std::string>& named = links[makefile.folder];
      for (const std::string& word : words) {
        if (folder_of_library.count(word) != 0 && folder_of_library[word] != makefile.folder) {
          named.insert(folder_of_library[word]);
        }
      }
    }
  }
  return links;
}

/// Every include of a folder's library that does not come with the libraries it depends on.
std::vector<std::string> unlinked_includes(const Links& links,
                                           const std::vector<SourceFile>& files) {
  const LayerTable reach(links);
  std::vector<std::string> problems;
  for (const SourceFile& file : files) {
    const std::string folder = fs::path(file.path).parent_path();
    for (const Include& include : includes_of(file)) {
      const bool has_library = links.count(fs::path(include.target).parent_path()) != 0;
      if (links.count(folder) != 0 && has_library && !reach.permits(folder, include.target)) {
        problems.push_back(file.path + ": " + include.target + " is not among its DEPENDS");
      }
    }
  }
  return problems;
}

std::vector<Makefile> makefiles_of_the_tree() {
  const fs::path root = ECHOMAP_SOURCE_DIR;
  std::vector<Makefile> makefiles;
  for (const std::string top : {"protocol", "firmware", "host", "hil_mock"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      if (entry.path().filename() == "CMakeLists.txt") {
        std::string text;
        for (const std::string& line : read_lines(entry.path())) {
          text += line + '\n';
        }
        makefiles.push_back({fs::relative(entry.path().parent_path(), root), text});
      }
    }
  }
  return makefiles;
}

TEST(LibraryLinks, EveryLibraryDependsOnWhatItsFilesInclude) {
  const Links links = links_of(makefiles_of_the_tree());
  EXPECT_GT(links.size(), 15U);
  EXPECT_THAT(unlinked_includes(links, read_source_tree(ECHOMAP_SOURCE_DIR)), IsEmpty());
}

TEST(LibraryLinks, NoneDependsOnWhatItMayNotInclude) {
  const LayerTable table(read_layer_rules(read_lines(ECHOMAP_SOURCE_DIR "/docs/architecture.md")));
  for (const auto& [folder, named] : links_of(makefiles_of_the_tree())) {
    for (const std::string& below : named) {
      // The firmware is one library: the table names its folders one by one.
      EXPECT_TRUE(folder == "firmware" || table.permits(folder, below + "/x.hpp"))
          << folder << " depends on " << below;
    }
  }
}

TEST(LibraryLinks, CatchAnIncludeThatNoDependencyBrings) {
  const Links links = links_of({{"host/a", "echomap_library(a SOURCES a.cpp DEPENDS)"},
                                {"host/b", "echomap_library(b SOURCES b.cpp DEPENDS a # low\n)"},
                                {"host/c", "echomap_library(c\n  SOURCES c.cpp DEPENDS b)"},
                                {"host/d", "echomap_library(d SOURCES d.cpp)"}});
  const std::vector<SourceFile> files{
      {"host/c/c.cpp", {"#include \"host/a/a.hpp\"", "#include \"host/d/d.hpp\""}}};
  EXPECT_THAT(unlinked_includes(links, files),
              ElementsAre("host/c/c.cpp: host/d/d.hpp is not among its DEPENDS"));
}

}  // namespace
}  // namespace echomap::structure
