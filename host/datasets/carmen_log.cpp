// SPDX-License-Identifier: MIT
#include "host/datasets/carmen_log.hpp"

#include <numbers>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

/// What counts as no return in a line that does not say.
constexpr double kFrontLaserMaxRangeM = 50.0;

/// The three last fields of every line; the first of them is the sensor's.
std::optional<double> read_stamp(FieldCursor& fields, RisingStamp& stamps) {
  const double stamp_s = fields.number("the time");
  fields.word("the host");
  fields.number("the logger's time");
  fields.expect_end();
  return stamps.accept(stamp_s);
}

void read_ranges(FieldCursor& fields, double first_rad, double step_rad, sensors::RangeScan& scan) {
  for (std::size_t i = 0; i < scan.beams.size(); ++i) {
    scan.beams[i] = {first_rad + step_rad * static_cast<double>(i),
                     sensors::returned_range_m(fields.number("a range"), scan.max_range_m)};
  }
}

class CarmenParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const std::string_view kind = fields.word("the kind of line");
    if (kind == "ODOM") {
      parse_odometry(fields, records);
    } else if (kind == "FLASER") {
      parse_front_laser(fields, records);
    } else if (kind == "ROBOTLASER1") {
      parse_robot_laser(fields, records);
    }
  }

 private:
  void parse_odometry(FieldCursor& fields, std::vector<LogRecord>& records) {
    const auto T_odom_robot = read_pose(fields, "the pose");
    for (const char* name : {"the speed", "the turn rate", "the acceleration"}) {
      fields.number(name);
    }
    records.emplace_back(OdometryPose{read_stamp(fields, odometry_stamps_), T_odom_robot});
  }

  void parse_front_laser(FieldCursor& fields, std::vector<LogRecord>& records) {
    sensors::RangeScan scan;
    scan.max_range_m = kFrontLaserMaxRangeM;
    const std::size_t count = fields.count("the number of ranges");
    scan.beams.resize(count);
    // 181 and 361 beams have one on either end of the half circle, 180 and 360 lack the last.
    const auto steps = static_cast<double>(count % 2 == 1 && count > 1 ? count - 1 : count);
    read_ranges(fields, -std::numbers::pi / 2.0, std::numbers::pi / steps, scan);
    const auto T_map_robot = read_pose(fields, "the pose");
    const auto T_odom_robot = read_pose(fields, "the odometry");
    scan.stamp_s = read_stamp(fields, laser_stamps_);
    records.emplace_back(OdometryPose{scan.stamp_s, T_odom_robot});
    records.emplace_back(GivenPose{scan.stamp_s, T_map_robot});
    records.emplace_back(std::move(scan));
  }

  void parse_robot_laser(FieldCursor& fields, std::vector<LogRecord>& records) {
    sensors::RangeScan scan;
    fields.number("the type of laser");
    const double first_rad = fields.number("the first bearing");
    fields.number("the field of view");
    const double step_rad = fields.number("the step of bearings");
    scan.max_range_m = fields.number("the maximum range");
    fields.number("the accuracy");
    fields.number("the remission mode");
    scan.beams.resize(fields.count("the number of ranges"));
    read_ranges(fields, first_rad, step_rad, scan);
    fields.skip(fields.count("the number of remissions"));
    const auto T_map_laser = read_pose(fields, "the pose of the laser");
    const auto T_map_robot = read_pose(fields, "the pose of the robot");
    for (const char* name :
         {"the speed", "the turn rate", "a distance", "a distance", "the axis"}) {
      fields.number(name);
    }
    scan.T_robot_sensor = T_map_robot.inverse() * T_map_laser;
    scan.stamp_s = read_stamp(fields, laser_stamps_);
    records.emplace_back(OdometryPose{scan.stamp_s, T_map_robot});
    records.emplace_back(GivenPose{scan.stamp_s, T_map_robot});
    records.emplace_back(std::move(scan));
  }

  RisingStamp odometry_stamps_;
  RisingStamp laser_stamps_;
};

}  // namespace

std::unique_ptr<LogReader> open_carmen_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<CarmenParser>());
}

}  // namespace echomap::datasets
