// SPDX-License-Identifier: MIT
#include "tests/benchmarks/edmonton_slam.hpp"

#include <filesystem>
#include <variant>

#include "host/datasets/edmonton_log.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/benchmarks/relation_log.hpp"
#include "tests/benchmarks/turn_first_odometry.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/played_log.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {

std::optional<EdmontonLog> read_edmonton() {
  const auto path = tests::real_data("edmonton") / "dataset_edmonton.rawlog_LASER.txt.gz";
  const auto known = read_relation_log("edm");
  if (!std::filesystem::exists(path) || !known) {
    return std::nullopt;
  }
  return EdmontonLog{tests::records_of(*datasets::open_edmonton_log(path)), known->relations};
}

std::vector<geometry::Pose2> paper_odometry(const EdmontonLog& log) {
  std::vector<geometry::Pose2> T_odom_scans;
  geometry::Pose2 T_odom_robot;
  for (const datasets::LogRecord& record : log.records) {
    if (const auto* step = std::get_if<datasets::OdometryStep>(&record)) {
      T_odom_robot = turned_then_driven(T_odom_robot, step->T_last_now);
    } else if (std::holds_alternative<sensors::RangeScan>(record)) {
      T_odom_scans.push_back(T_odom_robot);
    }
  }
  return T_odom_scans;
}

void run_edmonton(const EdmontonLog& log, slam::LandmarkSlam& method) {
  tests::SlamSink slam(method);
  tests::play(log.records, slam, pipeline::PoseSource::kOdometryFromOrigin);
}

}  // namespace echomap::bench
