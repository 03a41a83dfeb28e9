// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/structure/shell.hpp"
#include "tests/structure/tree_root.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::structure {

/// A folder that looks like the root of a clean tree after `./run build`, whatever runs its user
/// has left there, for commands to leave their files in. Its `run demo` skips the building, which
/// the test's own build has done.
class Desk {
 public:
  Desk() {
    std::filesystem::create_directories(folder_ / "build");
    for (const std::string name : {"CMakeLists.txt",
                                   "CMakePresets.json",
                                   "docs",
                                   "firmware",
                                   "hil_mock",
                                   "host",
                                   "packages.txt",
                                   "protocol",
                                   "tests"}) {
      std::filesystem::create_symlink(tree_root / name, folder_ / name);
    }
    std::filesystem::create_directory_symlink(ECHOMAP_BINARY_DIR, folder_ / "build" / "release");
    std::ofstream(folder_ / "run")
        << "#!/bin/sh\n"
        << "[ \"$1\" != demo ] || exec build/release/bin/echomap \"$@\"\n"
        << "exec " << shell_quoted((tree_root / "run").string()) << " \"$@\"\n";
    std::filesystem::permissions(folder_ / "run", std::filesystem::perms::owner_all);
  }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  const tests::ScratchFolder folder_;
};

}  // namespace echomap::structure
