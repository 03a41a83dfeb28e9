// SPDX-License-Identifier: MIT
/// Whether the page that is checked in is what its sources make, and their own tests.
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/structure/shell.hpp"

namespace echomap::live_page {
namespace {

namespace fs = std::filesystem;

/// A copy of the sources beside the packages that they need, and where they are built to.
const fs::path kCopy = fs::path(ECHOMAP_LIVE_PAGE_WEB) / "web";
const fs::path kBuilt = fs::path(ECHOMAP_LIVE_PAGE_WEB) / "built_page";
const fs::path kSources = fs::path(ECHOMAP_SOURCE_DIR) / "host/live_page/web";
const fs::path kCheckedIn = fs::path(ECHOMAP_SOURCE_DIR) / "host/live_page/built_page";

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

class LivePageSources : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kCopy / "installed")) {
      GTEST_SKIP() << "no node 20, no npm, or the page's packages could not be installed";
    }
    for (const std::string& name : names_in(kSources)) {
      if (name != "node_modules") {
        fs::remove_all(kCopy / name);
        fs::copy(kSources / name, kCopy / name, fs::copy_options::recursive);
      }
    }
  }
};

TEST_F(LivePageSources, MakeThePageThatIsCheckedIn) {
  fs::remove_all(kBuilt);
  const auto result = structure::run_shell("npm run build", kCopy);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  ASSERT_EQ(names_in(kBuilt), names_in(kCheckedIn));
  for (const std::string& name : names_in(kBuilt)) {
    EXPECT_TRUE(files::read_text_file(kBuilt / name) == files::read_text_file(kCheckedIn / name))
        << name << ": npm run build in host/live_page/web, and commit what it makes";
  }
}

TEST_F(LivePageSources, PassTheirOwnTests) {
  const auto result = structure::run_shell("npm test", kCopy);
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

}  // namespace
}  // namespace echomap::live_page
