// SPDX-License-Identifier: MIT
#include "host/papers/room_picture.hpp"

#include <gtest/gtest.h>

#include "tests/support/offline_exploration.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(RoomPicture, IsWrittenAndReturnedAndHasWhatIsDrawn) {
  const tests::ScratchFolder folder;
  const world::FloorPlan room = tests::bundled_room("empty_room");
  RoomPicture picture(room, {{exports::kGreen, "particles"}});
  const auto before = picture.write_png(folder / "before.png");
  picture.add_points({{1.0, 1.0}, {1.5, 0.5}}, 3.0, exports::kGreen);
  picture.add_robot({1.2, 0.9, 0.0}, 0.1, exports::kVermilion);
  const auto after = picture.write_png(folder / "sub/after.png");
  ASSERT_GT(after.size(), 8U);
  EXPECT_EQ(after[1], 'P');
  EXPECT_EQ(after.size(), file_size(folder / "sub/after.png"));
  EXPECT_NE(before, after);
}

TEST(RoomPicture, ShowsPathsAndEllipses) {
  const tests::ScratchFolder folder;
  RoomPicture picture(tests::bundled_room("epuck_field"), {}, 0.05);
  const auto empty = picture.write_png(folder / "empty.png");
  picture.add_path({{0.1, 0.1}, {0.7, 0.1}}, 2.0, exports::kBlue);
  const auto path = picture.write_png(folder / "path.png");
  picture.add_ellipse({0.4, 0.3}, 0.01 * Eigen::Matrix2d::Identity(), 1.0, exports::kBlue);
  EXPECT_NE(path, empty);
  EXPECT_NE(picture.write_png(folder / "ellipse.png"), path);
}

}  // namespace
}  // namespace echomap::papers
