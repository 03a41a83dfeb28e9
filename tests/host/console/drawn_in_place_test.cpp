// SPDX-License-Identifier: MIT
#include "host/console/drawn_in_place.hpp"

#include <gtest/gtest.h>

namespace echomap::console {
namespace {

class CountedDrawing final : public DrawnInPlace {
 public:
  void draw() { note_drawn(); }
  void clear() override {
    ++times_cleared;
    note_gone();
  }
  int times_cleared = 0;
};

TEST(DrawnInPlace, MakesWayOnceForEachDrawing) {
  CountedDrawing drawing;
  make_way_for_a_line();
  EXPECT_EQ(drawing.times_cleared, 0);
  drawing.draw();
  make_way_for_a_line();
  make_way_for_a_line();
  EXPECT_EQ(drawing.times_cleared, 1);
}

TEST(DrawnInPlace, OnlyTheLastThatWasDrawnMakesWay) {
  CountedDrawing first;
  CountedDrawing second;
  first.draw();
  second.draw();
  first.clear();
  make_way_for_a_line();
  EXPECT_EQ(second.times_cleared, 1);
  EXPECT_EQ(first.times_cleared, 1);
}

TEST(DrawnInPlace, MakesNoWayWhereItIsGone) {
  { CountedDrawing().draw(); }
  make_way_for_a_line();
}

}  // namespace
}  // namespace echomap::console
