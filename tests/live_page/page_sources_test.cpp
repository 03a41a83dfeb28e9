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

const fs::path kHost = fs::path(ECHOMAP_SOURCE_DIR) / "host";
const fs::path kSources = kHost / "live_page/web";
const fs::path kCheckedIn = kHost / "live_page/built_page";
/// A copy of the sources beside the packages that they need, and where they are built to.
const fs::path kHostCopy = fs::path(ECHOMAP_LIVE_PAGE_WEB) / "host";
const fs::path kCopy = kHostCopy / "live_page/web";
const fs::path kBuilt = kHostCopy / "live_page/built_page";

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

void link_all_but(const std::string& except, const fs::path& from, const fs::path& to) {
  for (const std::string& name : names_in(from)) {
    if (name != except) {
      fs::remove_all(to / name);
      fs::create_symlink(from / name, to / name);
    }
  }
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
    // Its tests look into the server's sources.
    link_all_but("live_page", kHost, kHostCopy);
    link_all_but("web", kHost / "live_page", kHostCopy / "live_page");
    fs::remove_all(kBuilt);
  }
};

TEST_F(LivePageSources, MakeThePageThatIsCheckedIn) {
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
