// SPDX-License-Identifier: MIT
#include "host/papers/edmonton.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

std::string scans(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    for (int beam = 0; beam < 180; ++beam) {
      text += "2.5 ";
    }
    text += '\n';
  }
  return text;
}

void write_scans(const tests::ScratchFolder& folder, bool is_packed) {
  const std::string name = "edmonton/dataset_edmonton.rawlog";
  std::filesystem::create_directories(folder / "edmonton");
  files::write_text_file(folder / (name + "_ODO.txt"), "0.1 0 0\n0.2 0 0.1\n");
  if (is_packed) {
    tests::write_gz(folder / (name + "_LASER.txt.gz"), scans(2));
  } else {
    files::write_text_file(folder / (name + "_LASER.txt"), scans(2));
  }
}

TEST(Edmonton, IsAbsentWhereThereAreNoScans) {
  const tests::ScratchFolder folder;
  EXPECT_FALSE(read_edmonton(folder.path()).has_value());
  EXPECT_EQ(edmonton_scans(folder.path()).extension(), ".gz");
}

TEST(Edmonton, IsReadPlainAndPacked) {
  for (const bool is_packed : {false, true}) {
    const tests::ScratchFolder folder;
    write_scans(folder, is_packed);
    const auto log = read_edmonton(folder.path());
    ASSERT_TRUE(log.has_value());
    EXPECT_EQ(log->records.size(), 3U) << "a scan, an increment, a scan";
    EXPECT_TRUE(log->relations.empty());
  }
}

TEST(Edmonton, HasTheRelationsBesideIt) {
  const tests::ScratchFolder folder;
  write_scans(folder, true);
  std::filesystem::create_directories(folder / "slam_relations");
  tests::write_gz(folder / "slam_relations/edm.assoc.gz", "0 1 0.1 0 0\n");
  const auto log = read_edmonton(folder.path());
  ASSERT_TRUE(log.has_value());
  EXPECT_EQ(log->relations.size(), 1U);
}

TEST(PublicLogs, AreWhereTheEnvironmentNamesThem) {
  const char* before = std::getenv("ECHOMAP_DATA");
  const std::string restored = before == nullptr ? "" : before;
  ::setenv("ECHOMAP_DATA", "/somewhere", 1);
  EXPECT_EQ(public_logs(), "/somewhere");
  ::unsetenv("ECHOMAP_DATA");
  EXPECT_EQ(public_logs().filename(), "data");
  if (before != nullptr) {
    ::setenv("ECHOMAP_DATA", restored.c_str(), 1);
  }
}

}  // namespace
}  // namespace echomap::papers
