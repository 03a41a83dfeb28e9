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

TEST(Heartbeat, OneSilentPartIsEnoughForAReset) {
  constexpr std::array<Part, 3> kParts{Part::kTick, Part::kControl, Part::kLink};
  for (const Part silent : kParts) {
    Heartbeat heartbeat;
    const std::uint32_t before = kicks();
    for (int i = 0; i < 300; ++i) {
      for (const Part part : kParts) {
        if (part != silent) {
          heartbeat.ran(part);
        }
      }
    }
    EXPECT_EQ(kicks(), before);
  }
}

}  // namespace
}  // namespace echomap::tasks
