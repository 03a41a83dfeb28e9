// SPDX-License-Identifier: MIT
#include "hil_mock/world/ir_switches.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::world {
namespace {

using geometry::radians;

FloorPlan room_with(const VirtualWall& beam, std::vector<Outline> obstacles = {}) {
  return {"beam",
          {rectangle(0.0, 0.0, 4.0, 3.0), {}},
          std::move(obstacles),
          {2.0, 1.5, 0.0},
          {{}, {beam}}};
}

const VirtualWall across{{0.0, 1.0}, 0.0, 2.0, radians(5.0)};

TEST(IrSwitches, ABeamReachesWhatIsInItsConeAndLength) {
  const FloorPlan plan = room_with(across);
  EXPECT_TRUE(beam_reaches(plan, across, {1.9, 1.0}));
  EXPECT_FALSE(beam_reaches(plan, across, {2.1, 1.0})) << "beyond its end";
  EXPECT_TRUE(beam_reaches(plan, across, {1.0, 1.0 + std::tan(radians(4.9))}));
  EXPECT_FALSE(beam_reaches(plan, across, {1.0, 1.0 + std::tan(radians(5.1))}));
  EXPECT_FALSE(beam_reaches(plan, {{1.0, 1.0}, 0.0, 2.0, radians(5.0)}, {0.5, 1.0})) << "behind";
}

TEST(IrSwitches, ABeamEndsAtAWall) {
  const FloorPlan plan = room_with(across, {{rectangle(0.5, 0.8, 0.7, 1.2), {}}});
  EXPECT_TRUE(beam_reaches(plan, across, {0.4, 1.0}));
  EXPECT_FALSE(beam_reaches(plan, across, {1.0, 1.0}));
}

TEST(IrSwitches, TheDetectorSeesAVirtualWallWhereItIsMounted) {
  const FloorPlan plan = room_with(across);
  const BeamDetectorParams detector{{0.1, 0.0}, 0.0, 0.0};
  EXPECT_TRUE(beam_detected(plan, {1.0, 0.9, radians(90.0)}, detector));
  EXPECT_FALSE(beam_detected(plan, {1.0, 0.9, radians(-90.0)}, detector));
}

TEST(IrSwitches, AnEmitterOnTheRobotShowsAWallAhead) {
  const FloorPlan plan = box_room();
  const BeamDetectorParams detector{{0.1, 0.0}, 0.5, radians(10.0)};
  EXPECT_TRUE(beam_detected(plan, {3.41, 1.5, 0.0}, detector));
  EXPECT_FALSE(beam_detected(plan, {3.39, 1.5, 0.0}, detector));
  EXPECT_FALSE(beam_detected(plan, {3.6, 1.5, radians(90.0)}, detector)) << "it is at the side";
}

TEST(IrSwitches, TheWallSensorSeesABrightWallFarther) {
  const WallSensorParams sensor{{0.0, -0.05, radians(-90.0)}, 0.1};
  const FloorPlan bright = box_room();
  EXPECT_TRUE(wall_detected(bright, {2.0, 0.149, 0.0}, sensor));
  EXPECT_FALSE(wall_detected(bright, {2.0, 0.151, 0.0}, sensor));
  const FloorPlan dark("dark",
                       {rectangle(0.0, 0.0, 4.0, 3.0), std::vector<Surface>(4, {{}, 0.225})},
                       {},
                       {2.0, 1.5, 0.0});
  EXPECT_TRUE(wall_detected(dark, {2.0, 0.099, 0.0}, sensor));
  EXPECT_FALSE(wall_detected(dark, {2.0, 0.101, 0.0}, sensor));
}

}  // namespace
}  // namespace echomap::world
