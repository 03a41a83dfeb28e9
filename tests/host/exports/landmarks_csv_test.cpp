// SPDX-License-Identifier: MIT
#include "host/exports/landmarks_csv.hpp"

#include <chrono>

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

TEST(LandmarksCsv, HasALineForEachSighting) {
  const tests::ScratchFolder folder;
  using std::chrono::microseconds;
  const time::RobotTime stamp(microseconds(1500000));
  write_landmarks_csv(folder / "a.csv",
                      {{stamp, 14, 2.5, -0.25, {1.0, -2.0}}, {stamp, 6, 0.1, 0.0, {0.5, 0.0}}});
  EXPECT_EQ(files::read_text_file(folder / "a.csv"),
            "stamp_s,id,range_m,bearing_rad,x_m,y_m\n1.5,14,2.5,-0.25,1,-2\n1.5,6,0.1,0,0.5,0\n");
}

TEST(LandmarksCsv, OfNoneIsItsHead) {
  const tests::ScratchFolder folder;
  write_landmarks_csv(folder / "a.csv", {});
  EXPECT_EQ(files::read_text_file(folder / "a.csv"), "stamp_s,id,range_m,bearing_rad,x_m,y_m\n");
}

}  // namespace
}  // namespace echomap::exports
