// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/own_folder.hpp"

#include <fstream>
#include <optional>

#include <gtest/gtest.h>

namespace echomap::ev3 {
namespace {

TEST(OwnFolder, GoesWithItsOwnerAndWithAllThatIsInIt) {
  std::optional<OwnFolder> folder(std::in_place);
  const OwnFolder other;
  const std::filesystem::path path = folder->path();
  EXPECT_NE(path, other.path());
  std::filesystem::create_directories(path / "sys/class");
  std::ofstream(path / "sys/class/file") << "1";
  folder.reset();
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(std::filesystem::exists(other.path()));
}

}  // namespace
}  // namespace echomap::ev3
