// SPDX-License-Identifier: MIT
#include "host/apps/live_score.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"
#include "tests/support/truth_files.hpp"

namespace echomap::apps {
namespace {

class LiveScoreTest : public testing::Test {
 protected:
  LiveScoreTest() { tests::write_truth_files(truth); }

  const tests::ScratchFolder scratch;
  const std::filesystem::path truth = scratch / "truth";
};

/// The floor of the true room from x = -0.5 m on, as far as that, in the frame of the start pose.
mapping::OccupancyGrid floor_up_to(int last_x) {
  mapping::OccupancyGrid grid;
  for (int y = -10; y < 12; ++y) {
    for (int x = -10; x < last_x; ++x) {
      grid.add({x, y}, -400);
    }
  }
  return grid;
}

TEST_F(LiveScoreTest, OfAMapThatIsTheRoomIsOne) {
  LiveScore score(truth);
  mapping::OccupancyGrid grid = floor_up_to(30);
  for (int y = -10; y < 12; ++y) {
    grid.add({30, y}, 400);
  }
  score.look_at(grid);
  const auto json = score.json({}, std::nullopt);
  EXPECT_DOUBLE_EQ(json.at("free_iou").get<double>(), 1.0);
  EXPECT_NEAR(json.at("wall_rmse_m").get<double>(), 0.025, 1e-9) << "half a cell";
  EXPECT_TRUE(json.at("objects_found").is_null()) << "the room is empty";
  EXPECT_TRUE(json.at("solid_called_free").is_null());
}

TEST_F(LiveScoreTest, GrowsWithTheMap) {
  LiveScore score(truth);
  score.look_at(floor_up_to(10));
  const auto half = score.json({}, std::nullopt);
  EXPECT_NEAR(half.at("free_iou").get<double>(), 0.5, 1e-9);
  EXPECT_TRUE(half.at("wall_rmse_m").is_null()) << "it has no wall yet";
  score.look_at(floor_up_to(30));
  EXPECT_DOUBLE_EQ(score.json({}, std::nullopt).at("free_iou").get<double>(), 1.0);
}

TEST_F(LiveScoreTest, TellsWhichObstaclesAreThere) {
  files::write_text_file(truth / "truth_walls.geojson",
                         R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
     "coordinates": [[0, 0], [2, 0], [2, 1.1], [0, 1.1], [0, 0]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "LineString",
     "coordinates": [[1, 0.5], [1, 0.7], [1.2, 0.7], [1.2, 0.5], [1, 0.5]]}}]})");
  LiveScore score(truth);
  score.look_at(floor_up_to(30));
  EXPECT_EQ(score.json({}, std::nullopt).at("objects_found"), 0.0);
  EXPECT_DOUBLE_EQ(score.json({}, std::nullopt).at("solid_called_free").get<double>(), 1.0);
  mapping::OccupancyGrid grid = floor_up_to(30);
  for (int y = 0; y < 4; ++y) {
    for (int x = 10; x < 14; ++x) {
      grid.add({x, y}, 500);
      grid.add({x, y}, 500);
    }
  }
  score.look_at(grid);
  EXPECT_EQ(score.json({}, std::nullopt).at("objects_found"), 1.0);
  EXPECT_DOUBLE_EQ(score.json({}, std::nullopt).at("solid_called_free").get<double>(), 0.0);
}

TEST_F(LiveScoreTest, HasTheErrorOfAPoseWhoseTruthIsKnown) {
  LiveScore score(truth);
  score.look_at(floor_up_to(30));
  EXPECT_DOUBLE_EQ(
      score.json({0.3, 0.0, 1.0}, geometry::Pose2(0.0, 0.4, 2.0)).at("pose_error_m").get<double>(),
      0.5);
  EXPECT_TRUE(score.json({}, std::nullopt).at("pose_error_m").is_null());
}

TEST_F(LiveScoreTest, NeedsTheRoomAndAPose) {
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { LiveScore(scratch / "none"); }),
              testing::HasSubstr("truth_map.yaml"));
  files::write_text_file(truth / "truth.tum", "");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { LiveScore score(truth); }),
              testing::HasSubstr("truth.tum"));
}

}  // namespace
}  // namespace echomap::apps
