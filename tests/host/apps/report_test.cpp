// SPDX-License-Identifier: MIT
#include "host/apps/report.hpp"

#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/robot_profile.hpp"
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
  score.start.map.wall_rmse_m = 0.03;
  EXPECT_EQ(to_json(score)["wall_rmse_m"], 0.03);
}

TEST(Report, WhatHasNoObstacleHasNoScoreOfOne) {
  evaluation::RunScore score;
  for (const auto& json : {to_json(score), to_json(score)["fitted"]}) {
    for (const char* key : {"solid_called_free",
                            "wall_band_called_free",
                            "objects_found",
                            "path_found_share",
                            "path_collision_share"}) {
      EXPECT_TRUE(json.at(key).is_null()) << key;
    }
  }
}

TEST(Report, HasTheScoresOfBothPlacements) {
  evaluation::RunScore score;
  score.start.obstacles = {0.25, 0.5, 4, 3};
  score.start.paths = {200, 100, 5};
  score.fitted.obstacles.solid_called_free = 0.125;
  score.fitted.map.free_iou = 0.75;
  score.fit_turn_rad = geometry::radians(2.0);
  const auto json = to_json(score);
  EXPECT_EQ(json.at("solid_called_free"), 0.25);
  EXPECT_EQ(json.at("wall_band_called_free"), 0.5);
  EXPECT_EQ(json.at("objects_found"), 0.75);
  EXPECT_EQ(json.at("path_found_share"), 0.5);
  EXPECT_EQ(json.at("path_collision_share"), 0.05) << "of those found";
  EXPECT_EQ(json.at("fitted").at("solid_called_free"), 0.125);
  EXPECT_EQ(json.at("fitted").at("free_iou"), 0.75);
  EXPECT_NEAR(json.at("fit_turn_deg").get<double>(), 2.0, 1e-12);
}

TEST(Report, TakesTheRobotsRadiusFromTheRun) {
  const session::TemporaryFolder folder;
  EXPECT_EQ(radius_of_robot(folder.path()), evaluation::kDefaultRobotRadiusM);
  files::write_text_file(folder / "robot.toml", session::load_robot_profile("create").toml);
  EXPECT_EQ(radius_of_robot(folder.path()), 0.165);
}

TEST(Report, OutputsArePreparedWithoutATrace) {
  const session::TemporaryFolder folder;
  files::write_text_file(folder / "report.json", "older");
  prepare_outputs(folder / "a/run", folder / "report.json", false);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/run"));
  EXPECT_EQ(files::read_text_file(folder / "report.json"), "older");
  EXPECT_NO_THROW(prepare_outputs(folder / "a/run", "-", false));
}

TEST(Report, ARunIsNotOverwrittenUnasked) {
  const session::TemporaryFolder folder;
  files::write_text_file(folder / "map.pgm", "no run, only a map");
  EXPECT_NO_THROW(prepare_outputs(folder.path(), {}, false));
  files::write_text_file(folder / "summary.json", "{}");
  try {
    prepare_outputs(folder.path(), {}, false);
    FAIL() << "it would overwrite the run";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kUsage);
    EXPECT_NE(std::string(error.what()).find("--force"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(prepare_outputs(folder.path(), {}, true));
  EXPECT_EQ(files::read_text_file(folder / "summary.json"), "{}");
}

TEST(Report, OutputsThatCannotBeWrittenAreRefused) {
  const session::TemporaryFolder folder;
  files::write_text_file(folder / "file", "");
  EXPECT_THROW(prepare_outputs(folder / "file/run", {}, false), files::FileError);
  EXPECT_THROW(prepare_outputs(folder / "run", folder / "none/report.json", false),
               files::FileError);
  EXPECT_THROW(prepare_outputs(folder / "run", folder.path(), false), files::FileError);
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
