// SPDX-License-Identifier: MIT
/// The receive buffer at 50 bytes a millisecond, with everything else going on.
#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/release_images.hpp"

namespace echomap::tests {
namespace {

TEST(ReceiveCredit, NothingKeepsTheRobotFromReadingForAsLongAsItsBufferLasts) {
  // The host's line never rests: whoever does not read for 2.6 ms loses bytes.
  LoadedRobot robot(release_image("echomap-uno-500000"),
                    {.edges_per_s = 20'000, .full_line = false, .sweeps_on = true});
  robot.connect();
  std::uint64_t bytes = 0;
  robot.session().each_ms = [&] {
    for (int i = 0; i < 5; ++i) {
      robot.session().send(protocol::KeepAlive{200});
      bytes += protocol::kFrameOverhead + protocol::MessageFacts<protocol::KeepAlive>::kSize;
    }
  };
  robot.run_s(10.0);
  const LoadResult result = robot.finish();
  std::printf("500000 baud: %.0f B/s of frames in, %.0f B/s out, overruns %d\n",
              double(bytes) / result.seconds,
              result.robot_bytes_per_s,
              result.receive_overruns);
  EXPECT_EQ(result.receive_overruns, 0);
  EXPECT_EQ(result.frames_bad, 0);
  EXPECT_EQ(result.frames_lost, 0);
  EXPECT_EQ(result.miscounts, 0);
  EXPECT_TRUE(result.under_control);
}

}  // namespace
}  // namespace echomap::tests
