// SPDX-License-Identifier: MIT
#include "host/apps/report.hpp"

#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/session/temporary_folder.hpp"

namespace echomap::apps {
namespace {

TEST(Report, AStampedRunFolderStandsInTheUsersData) {
  ::setenv("XDG_DATA_HOME", "/data", 1);
  const auto folder = run_folder({}).string();
  EXPECT_TRUE(folder.starts_with("/data/echomap/runs/20")) << folder;
  EXPECT_EQ(run_folder("mine"), "mine");
}

TEST(Report, AMapWithoutWallsHasNoWallError) {
  evaluation::RunScore score;
  EXPECT_TRUE(to_json(score)["wall_rmse_m"].is_null());
  score.map.wall_rmse_m = 0.03;
  EXPECT_EQ(to_json(score)["wall_rmse_m"], 0.03);
}

TEST(Report, OutputsArePreparedWithoutATrace) {
  const session::TemporaryFolder folder;
  files::write_text_file(folder / "report.json", "older");
  prepare_outputs(folder / "a/run", folder / "report.json");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/run"));
  EXPECT_EQ(files::read_text_file(folder / "report.json"), "older");
  EXPECT_NO_THROW(prepare_outputs(folder / "a/run", "-"));
}

TEST(Report, OutputsThatCannotBeWrittenAreRefused) {
  const session::TemporaryFolder folder;
  files::write_text_file(folder / "file", "");
  EXPECT_THROW(prepare_outputs(folder / "file/run", {}), files::FileError);
  EXPECT_THROW(prepare_outputs(folder / "run", folder / "none/report.json"), files::FileError);
  EXPECT_THROW(prepare_outputs(folder / "run", folder.path()), files::FileError);
}

TEST(Report, IsWrittenToItsFile) {
  const session::TemporaryFolder folder;
  const auto path = folder / "report.json";
  write_report(path, {{"free_iou", 0.9}});
  EXPECT_EQ(nlohmann::json::parse(files::read_text_file(path))["free_iou"], 0.9);
  EXPECT_NO_THROW(write_report({}, {}));
}

}  // namespace
}  // namespace echomap::apps
