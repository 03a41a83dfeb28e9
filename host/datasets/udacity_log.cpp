// SPDX-License-Identifier: MIT
#include "host/datasets/udacity_log.hpp"

#include <array>
#include <utility>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr std::array kBearingsDeg{-90.0, -37.5, -22.5, -7.5, 7.5, 22.5, 37.5, 90.0};
constexpr double kBeamWidthDeg = 20.0;
constexpr double kMaxRangeM = 5.11;
constexpr PoseUnits kMillimetresAndTenths{0.001, geometry::radians(0.1)};

class UdacityParser : public LineParser {
 public:
  explicit UdacityParser(const std::filesystem::path& path)
      : poses_(required_companion(path, "measurement.txt", "poses.txt")) {}

  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const double time_ms = fields.number("the time");
    FieldCursor pose_fields = poses_.require(lines);
    const double pose_ms = pose_fields.number("the time");
    const auto T_map_robot = read_pose(pose_fields, "the pose", kMillimetresAndTenths);
    pose_fields.expect_end();
    if (pose_ms != time_ms) {
      lines.fail("the pose of this line has another time");
    }
    const auto stamp_s = stamps_.accept(time_ms / 1000.0);
    records.emplace_back(GivenPose{stamp_s, T_map_robot});
    sensors::RangeScan scan{stamp_s, {}, {}, geometry::radians(kBeamWidthDeg), kMaxRangeM};
    for (const double bearing_deg : kBearingsDeg) {
      const double range_m = fields.number("a range") / 1000.0;
      scan.beams.push_back(
          {geometry::radians(bearing_deg), sensors::returned_range_m(range_m, kMaxRangeM)});
    }
    fields.expect_end();
    records.emplace_back(std::move(scan));
  }

 private:
  CompanionLines poses_;
  RisingStamp stamps_;
};

}  // namespace

std::unique_ptr<LogReader> open_udacity_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<UdacityParser>(path));
}

}  // namespace echomap::datasets
