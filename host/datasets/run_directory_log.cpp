// SPDX-License-Identifier: MIT
#include "host/datasets/run_directory_log.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

/// A row of points.csv.
struct Echo {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  std::int64_t pose_index = 0;
};

class RunDirectoryLog : public LogReader {
 public:
  explicit RunDirectoryLog(const std::filesystem::path& folder)
      : poses_(folder / "poses.csv"), points_(folder / "points.csv", LineReader::Role::kCompanion) {
    expect_header(poses_, "x_m,y_m,heading_rad");
    expect_header(points_, "x_m,y_m,pose_index");
    read_echo();
  }

  std::optional<LogRecord> next() override {
    if (given_) {
      return std::exchange(given_, std::nullopt);
    }
    if (scan_) {
      return std::exchange(scan_, std::nullopt);
    }
    const auto line = poses_.next();
    if (!line) {
      if (echo_) {
        points_.fail("no pose of poses.csv has this index");
      }
      return std::nullopt;
    }
    FieldCursor fields(poses_, *line, Separator::kComma);
    const auto T_map_robot = read_pose(fields, "the pose");
    fields.expect_end();
    read_scan(T_map_robot);
    ++pose_index_;
    given_ = GivenPose{std::nullopt, T_map_robot};
    return OdometryPose{std::nullopt, T_map_robot};
  }

  double progress() const override { return points_.progress(); }

 private:
  static void expect_header(LineReader& lines, std::string_view header) {
    const auto line = lines.next();
    if (!line || *line != header) {
      lines.fail("expected the header '" + std::string(header) + "'");
    }
  }

  void read_echo() {
    echo_.reset();
    if (const auto line = points_.next()) {
      FieldCursor fields(points_, *line, Separator::kComma);
      Echo echo;
      echo.position_m.x() = fields.number("x");
      echo.position_m.y() = fields.number("y");
      echo.pose_index = fields.integer("the index of the pose");
      fields.expect_end();
      if (echo.pose_index < pose_index_) {
        points_.fail("the index of the pose falls, points stand in the order of their poses");
      }
      echo_ = echo;
    }
  }

  /// Collects the echoes that the pose with this index saw.
  void read_scan(const geometry::Pose2& T_map_robot) {
    sensors::RangeScan scan;
    scan.max_range_m = std::numeric_limits<double>::infinity();
    const geometry::Pose2 T_robot_map = T_map_robot.inverse();
    while (echo_ && echo_->pose_index == pose_index_) {
      const Eigen::Vector2d echo_m = T_robot_map * echo_->position_m;
      scan.beams.push_back({std::atan2(echo_m.y(), echo_m.x()), echo_m.norm()});
      if (scan.beams.size() > kMaxEchoes) {
        points_.fail("more echoes of one pose than a scan has");
      }
      read_echo();
    }
    if (!scan.beams.empty()) {
      scan_ = std::move(scan);
    }
  }

  static constexpr std::size_t kMaxEchoes = 100000;

  LineReader poses_;
  LineReader points_;
  std::int64_t pose_index_ = 0;
  std::optional<Echo> echo_;
  std::optional<GivenPose> given_;
  std::optional<sensors::RangeScan> scan_;
};

}  // namespace

std::unique_ptr<LogReader> open_run_directory_log(const std::filesystem::path& path) {
  const bool is_folder = std::filesystem::is_directory(path);
  return std::make_unique<RunDirectoryLog>(is_folder ? path : path.parent_path());
}

}  // namespace echomap::datasets
