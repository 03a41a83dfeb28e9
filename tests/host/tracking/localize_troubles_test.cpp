// SPDX-License-Identifier: MIT
#include "host/tracking/localize_troubles.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::tracking {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const mapping::RasterMap kSmallRoom =
    tests::map_from({"##########", "#........#", "#........#", "#........#", "##########"}, 0.1);

sensors::RangeScan scan(double stamp_s, double range_m = 0.2) {
  sensors::RangeScan scan;
  scan.stamp_s = stamp_s;
  scan.max_range_m = 4.0;
  scan.beam_width_rad = 0.4;
  scan.beams.push_back({0.0, range_m});
  return scan;
}

std::string reason(const mapping::RasterMap& map, const std::vector<sensors::RangeScan>& scans) {
  pipeline::RobotLocalizer localizer(map, {}, {}, std::mt19937(1));
  for (const sensors::RangeScan& one : scans) {
    localizer.on_range_scan(one);
  }
  return why_nowhere(localizer, "a.log", "a.yaml");
}

TEST(LocalizeTroubles, SayWhyTheRobotIsNowhere) {
  EXPECT_EQ(reason(kSmallRoom, {}),
            "a.log holds no ranges, and no contacts of a robot without them\n"
            "  next: name the log or the run of a robot that has driven in that room");
  EXPECT_EQ(reason(mapping::RasterMap(5, 5, 0.1, {0.0, 0.0}), {scan(0.0)}),
            "a.yaml: no cell of the map is known");
  EXPECT_EQ(reason(tests::map_from({"###", "###"}, 0.1), {scan(0.0)}),
            "a.yaml: no cell of the map is free: there is no floor where a robot could be");
  EXPECT_EQ(reason(kSmallRoom, {scan(0.0, std::numeric_limits<double>::quiet_NaN())}),
            "a.log: no reading has a finite range and pose");
}

TEST(LocalizeTroubles, AreNoneWhenAllIsWell) {
  pipeline::RobotLocalizer localizer(kSmallRoom, {}, {}, std::mt19937(1));
  localizer.start_at({0.4, 0.2, 0.0}, 0.1, 0.1);
  localizer.on_range_scan(scan(0.0));
  EXPECT_THAT(troubles_of(localizer), IsEmpty());
}

TEST(LocalizeTroubles, NameAStartOffTheMapAndTimeThatRunsBackwards) {
  pipeline::RobotLocalizer localizer(kSmallRoom, {}, {}, std::mt19937(1));
  localizer.start_at({40.0, 0.2, 0.0}, 0.1, 0.1);
  localizer.on_range_scan(scan(3.0));
  localizer.on_range_scan(scan(2.0));
  localizer.on_range_scan(scan(1.0));
  EXPECT_THAT(troubles_of(localizer),
              ElementsAre("cannot start at that pose: the estimated pose was off the floor of the "
                          "map; localizing globally",
                          "2 scans were skipped: time ran backwards"));
}

}  // namespace
}  // namespace echomap::tracking
