// SPDX-License-Identifier: MIT
#include "host/fleet/own_folder.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::fleet {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(OwnFolder, GivesObjectsBackInTheirOrderAndThenGraphs) {
  const tests::ScratchFolder folder;
  OwnFolder own(folder.path() / "r1");
  EXPECT_THAT(own.load(), IsEmpty());
  EXPECT_TRUE(own.save_object("first"));
  EXPECT_TRUE(own.save_graph(0, "graph"));
  EXPECT_TRUE(own.save_object(std::string("\0second", 7)));
  EXPECT_TRUE(own.save_graph(0, "newer graph"));
  EXPECT_THAT(OwnFolder(folder.path() / "r1").load(),
              ElementsAre("first", std::string("\0second", 7), "newer graph"));
}

TEST(OwnFolder, OverwritesNoObjectAfterAStart) {
  const tests::ScratchFolder folder;
  OwnFolder(folder.path()).save_object("first");
  OwnFolder again(folder.path());
  again.load();
  again.save_object("second");
  EXPECT_THAT(OwnFolder(folder.path()).load(), ElementsAre("first", "second"));
}

TEST(OwnFolder, OverwritesNoObjectWhereEarlierOnesAreMissing) {
  const tests::ScratchFolder folder;
  OwnFolder own(folder.path());
  for (const char* payload : {"first", "second", "third"}) {
    own.save_object(payload);
  }
  std::filesystem::remove(folder.path() / "1-object-00000000.bin");
  std::filesystem::remove(folder.path() / "1-object-00000001.bin");
  OwnFolder again(folder.path());
  again.load();
  again.save_object("fourth");
  again.save_object("fifth");
  EXPECT_THAT(OwnFolder(folder.path()).load(), ElementsAre("third", "fourth", "fifth"));
}

TEST(OwnFolder, KeepsNothingWithoutAPath) {
  OwnFolder own("");
  EXPECT_TRUE(own.save_object("first"));
  EXPECT_THAT(own.load(), IsEmpty());
}

TEST(OwnFolder, SaysWhereItCannotWrite) {
  const tests::ScratchFolder folder;
  OwnFolder own(folder.path() / "r1");
  std::filesystem::remove_all(folder.path() / "r1");
  EXPECT_FALSE(own.save_object("first"));
  std::ofstream(folder.path() / "file") << "no folder";
  EXPECT_THROW(OwnFolder(folder.path() / "file"), files::FileError);
}

}  // namespace
}  // namespace echomap::fleet
