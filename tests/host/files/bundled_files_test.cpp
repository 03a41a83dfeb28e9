// SPDX-License-Identifier: MIT
#include "host/files/bundled_files.hpp"

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/toml_reader.hpp"

namespace echomap::files {
namespace {

TEST(BundledFile, FindsANameAmongTheBundledOnes) {
  EXPECT_TRUE(std::filesystem::exists(bundled_file("uno_2wd", "host/profiles", "robot profile")));
}

TEST(BundledFile, LeavesAPathAsItStands) {
  EXPECT_EQ(bundled_file("my.toml", "host/profiles", "robot profile"), "my.toml");
  EXPECT_EQ(bundled_file("./mine", "host/profiles", "robot profile"), "./mine");
}

TEST(BundledFile, ListsTheNamesOfAFolder) {
  const auto names = bundled_names("host/profiles");
  EXPECT_THAT(names, ::testing::IsSupersetOf({"create", "epuck", "uno_2wd"}));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(BundledFile, NamesTheNearestOne) {
  try {
    bundled_file("uno_2dw", "host/profiles", "robot profile");
    FAIL() << "an unknown name was taken";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("no robot profile is named 'uno_2dw'"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("did you mean 'uno_2wd'?"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("next: name a bundled one, or a file"));
  }
}

}  // namespace
}  // namespace echomap::files
