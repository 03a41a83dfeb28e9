// SPDX-License-Identifier: MIT
#include "firmware/tasks/heartbeat.hpp"

#include <array>

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::tasks {
namespace {

std::uint32_t kicks() { return native::NativeBoard::instance().watchdog_kicks(); }

TEST(Heartbeat, KicksOnceWhenEveryPartHasRun) {
  Heartbeat heartbeat;
  const std::uint32_t before = kicks();
  heartbeat.ran(Part::kLink);
  heartbeat.ran(Part::kTick);
  EXPECT_EQ(kicks(), before);
  heartbeat.ran(Part::kControl);
  EXPECT_EQ(kicks(), before + 1);
  heartbeat.ran(Part::kControl);
  EXPECT_EQ(kicks(), before + 1);
}

/// Lets every part but this one run 300 times; how often that kicked.
std::uint32_t kicks_without(Part silent) {
  constexpr std::array<Part, 3> kParts{Part::kTick, Part::kControl, Part::kLink};
  Heartbeat heartbeat;
  const std::uint32_t before = kicks();
  for (int i = 0; i < 300; ++i) {
    for (const Part part : kParts) {
      if (part != silent) {
        heartbeat.ran(part);
      }
    }
  }
  return kicks() - before;
}

TEST(Heartbeat, OneSilentPartIsEnoughForAReset) {
  EXPECT_EQ(kicks_without(Part::kTick), 0U);
  EXPECT_EQ(kicks_without(Part::kControl), 0U);
  EXPECT_EQ(kicks_without(Part::kLink), 0U);
}

}  // namespace
}  // namespace echomap::tasks
