// SPDX-License-Identifier: MIT
#include "host/datasets/wean_log.hpp"

#include <utility>

#include "host/datasets/line_log.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr PoseUnits kCentimetres{0.01, 1.0};
constexpr std::size_t kBeams = 180;
constexpr double kMaxRangeM = 81.8;

class WeanParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const std::string_view kind = fields.word("the kind of line");
    if (kind == "O") {
      const auto T_odom_robot = read_pose(fields, "the pose", kCentimetres);
      records.emplace_back(OdometryPose{read_stamp(fields, odometry_stamps_), T_odom_robot});
    } else if (kind == "L") {
      parse_laser(fields, records);
    } else {
      fields.fail("the kind of line", kind, "not O or L");
    }
  }

 private:
  static std::optional<double> read_stamp(FieldCursor& fields, RisingStamp& stamps) {
    const double stamp_s = fields.number("the time");
    fields.expect_end();
    return stamps.accept(stamp_s);
  }

  void parse_laser(FieldCursor& fields, std::vector<LogRecord>& records) {
    const auto T_odom_robot = read_pose(fields, "the pose", kCentimetres);
    const auto T_odom_laser = read_pose(fields, "the pose of the laser", kCentimetres);
    sensors::RangeScan scan;
    scan.T_robot_sensor = T_odom_robot.inverse() * T_odom_laser;
    scan.max_range_m = kMaxRangeM;
    scan.beams.reserve(kBeams);
    for (std::size_t i = 0; i < kBeams; ++i) {
      const double range_m = fields.number("a range") * kCentimetres.length_m;
      scan.beams.push_back({geometry::radians(static_cast<double>(i) - 90.0),
                            sensors::returned_range_m(range_m, kMaxRangeM)});
    }
    scan.stamp_s = read_stamp(fields, laser_stamps_);
    records.emplace_back(OdometryPose{scan.stamp_s, T_odom_robot});
    records.emplace_back(std::move(scan));
  }

  RisingStamp odometry_stamps_;
  RisingStamp laser_stamps_;
};

}  // namespace

std::unique_ptr<LogReader> open_wean_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<WeanParser>());
}

}  // namespace echomap::datasets
