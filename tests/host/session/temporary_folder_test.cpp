// SPDX-License-Identifier: MIT
#include "host/session/temporary_folder.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"

namespace echomap::session {
namespace {

TEST(TemporaryFolder, GoesWithAllThatIsInIt) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    files::write_text_file(folder / "file", "something");
    EXPECT_TRUE(std::filesystem::exists(path / "file"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TemporaryFolder, IsNobodyElses) {
  const TemporaryFolder first;
  const TemporaryFolder second;
  EXPECT_NE(first.path(), second.path());
  const auto permissions = std::filesystem::status(first.path()).permissions();
  EXPECT_EQ(permissions, std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace echomap::session
