// SPDX-License-Identifier: MIT
#include "host/exports/observations_csv.hpp"

#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "tests/support/robot_times.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::exports {
namespace {

using tests::at_us;

TEST(ObservationsCsvTest, IsAsItsDocumentSays) {
  const tests::ScratchFolder scratch;
  ObservationsCsv table;
  table.begin_scan();
  table.on_odometry({at_us(5), {0.1, -0.25}});
  table.on_sonar({at_us(6), {0.1, 1e-9}, -1.5, std::nullopt});
  table.on_sonar({at_us(7), {0.1, 0.2}, 0.0, 2.0});
  table.on_sonar({at_us(7), {0.1, 0.2}, 0.0, std::nullopt, false});
  table.on_infrared({at_us(8), {0.1, 0.2}, {0.5, std::nullopt}});
  table.on_hazards({.stamp = at_us(9), .bump_right = true, .cliffs = {true}, .lifted = true});
  table.on_scalar({at_us(9), {0.1, 0.2}, 7.0, 0.25});
  table.on_battery({at_us(10), 7.0});
  table.end_scan();
  table.on_carried({at_us(11), {0.1, 0.2}, {1.5, -2.0, 0.25}});
  table.on_pose_fix({at_us(12), {1.25, -2.0, 0.5}});
  table.save(scratch / "record");
  EXPECT_EQ(files::read_text_file(scratch / "record"),
            "kind,stamp_us,values\n"
            "begin-scan\n"
            "odometry,5,0.1,-0.25\n"
            "sonar,6,0.1,1e-09,-1.5,none\n"
            "sonar,7,0.1,0.2,0,2\n"
            "sonar,7,0.1,0.2,0,silent\n"
            "infrared,8,0.1,0.2,0.5,none\n"
            "hazards,9,0,1,1,0,0,0,1,0,0\n"
            "scalar,9,0.1,0.2,7,0.25\n"
            "end-scan\n"
            "carried,11,0.1,0.2,1.5,-2,0.25\n"
            "fix,12,1.25,-2,0.5\n");
}

TEST(ObservationsCsvTest, ThrowsWhereItCannotBeWritten) {
  EXPECT_THROW(ObservationsCsv().save("/nowhere/observations.csv"), files::FileError);
}

}  // namespace
}  // namespace echomap::exports
