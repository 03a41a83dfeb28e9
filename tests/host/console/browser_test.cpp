// SPDX-License-Identifier: MIT
#include "host/console/browser.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace echomap::console {
namespace {

namespace fs = std::filesystem;

/// Puts an xdg-open that writes its argument to a file in front of the path, or none.
class Browser : public testing::Test {
 protected:
  Browser() {
    fs::create_directories(folder);
    ::setenv("PATH", (folder.string() + ":/bin").c_str(), 1);
  }
  ~Browser() override {
    ::setenv("PATH", path.c_str(), 1);
    fs::remove_all(folder);
  }

  std::string path = std::getenv("PATH");
  fs::path folder = fs::path(testing::TempDir()) / "browser_test";
};

TEST_F(Browser, IsGivenTheUrlAsItIs) {
  const fs::path opener = folder / "xdg-open";
  const fs::path told = folder / "told";
  std::ofstream(opener) << "#!/bin/sh\necho \"$1\" > '" << told.string() << "'\n";
  fs::permissions(opener, fs::perms::owner_all);
  ASSERT_TRUE(open_in_browser("http://127.0.0.1:1/?token=a$b"));
  std::string url;
  for (int i = 0; i < 200 && url.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::getline(std::ifstream(told) >> std::ws, url);
  }
  EXPECT_EQ(url, "http://127.0.0.1:1/?token=a$b");
}

TEST_F(Browser, ADesktopIsNotSeenBySsh) {
  ::setenv("DISPLAY", ":7", 1);
  ::unsetenv("SSH_CONNECTION");
  EXPECT_TRUE(has_desktop());
  ::setenv("SSH_CONNECTION", "1.2.3.4", 1);
  EXPECT_FALSE(has_desktop());
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  ::unsetenv("SSH_CONNECTION");
  EXPECT_FALSE(has_desktop());
}

}  // namespace
}  // namespace echomap::console
