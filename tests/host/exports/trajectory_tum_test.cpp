// SPDX-License-Identifier: MIT
#include "host/exports/trajectory_tum.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::exports {
namespace {

using ::testing::HasSubstr;

pipeline::StampedPose at(std::int64_t stamp_us, const geometry::Pose2& pose) {
  return {time::RobotTime(time::RobotClock::duration(stamp_us)), pose};
}

TEST(TrajectoryTum, HasEightColumnsAndSingleSpaces) {
  const tests::ScratchFolder folder;
  write_trajectory_tum(folder / "trajectory.tum",
                       {at(0, {}), at(1'250'000, {1.5, -0.25, std::numbers::pi / 2.0})});
  EXPECT_EQ(files::read_text_file(folder / "trajectory.tum"),
            "0.000000 0.000000 0.000000 0 0 0 0.000000000 1.000000000\n"
            "1.250000 1.500000 -0.250000 0 0 0 0.707106781 0.707106781\n");
}

TEST(TrajectoryTum, ReadsBackWhatItWrote) {
  const tests::ScratchFolder folder;
  std::vector<pipeline::StampedPose> trajectory;
  for (int i = 0; i < 200; ++i) {
    trajectory.push_back(at(i * 20'001, {0.01 * i, -0.02 * i, 0.05 * i}));
  }
  write_trajectory_tum(folder / "t.tum", trajectory);
  const auto read = read_trajectory_tum(folder / "t.tum");
  ASSERT_EQ(read.size(), trajectory.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].stamp, trajectory[i].stamp);
    const geometry::Pose2 off = read[i].T_map_robot.inverse() * trajectory[i].T_map_robot;
    EXPECT_NEAR(off.position_m().norm(), 0.0, 2e-6);
    EXPECT_NEAR(off.heading_rad(), 0.0, 1e-8);
  }
}

TEST(TrajectoryTum, RefusesASeventhColumnTooFew) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "t.tum", "# t x y z q\n0 0 0 0 0 0 0 1\n0.1 0 0 0 0 0 1\n");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { read_trajectory_tum(folder / "t.tum"); }),
              HasSubstr("t.tum:3: expected 8 columns, found 7"));
}

TEST(TrajectoryTum, RefusesAStampThatNoClockCounts) {
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "t.tum", "# t x y z q\n0 0 0 0 0 0 0 1\n-1e300 0 0 0 0 0 0 1\n");
  EXPECT_THAT(tests::thrown_text<files::FileError>([&] { read_trajectory_tum(folder / "t.tum"); }),
              HasSubstr("t.tum:3: outside the range of seconds"));
}

}  // namespace
}  // namespace echomap::exports
