// SPDX-License-Identifier: MIT
#include "host/papers/confidence_picture.hpp"

#include <gtest/gtest.h>

#include "tests/support/offline_exploration.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

TEST(ConfidencePicture, IsWrittenAndReturnedAndShowsWhatIsConfident) {
  const tests::ScratchFolder folder;
  const world::FloorPlan room = tests::bundled_room("empty_room");
  mapping::CellField confidence({{0, 0}, {49, 39}}, 0.05);
  const auto empty = draw_confidence(folder / "sub/empty.png", confidence, room);
  confidence[confidence.index({10, 10})] = 20.0F;
  const auto filled =
      draw_confidence(folder / "filled.png", confidence, room, {{0.5, 0.5}, {1, 1}});
  EXPECT_EQ(empty.size(), file_size(folder / "sub/empty.png"));
  ASSERT_GT(filled.size(), 8U);
  EXPECT_EQ(filled[1], 'P');
  EXPECT_NE(empty, filled);
}

}  // namespace
}  // namespace echomap::papers
