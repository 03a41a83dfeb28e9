// SPDX-License-Identifier: MIT
#include "host/datasets/mrclam_team.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/datasets/mrclam_log.hpp"

namespace echomap::datasets {
namespace {

constexpr std::string_view kRobot = "Robot";
constexpr std::string_view kOdometry = "_Odometry.dat";
constexpr std::size_t kMaxLandmarks = 1000;

/// The N of RobotN_Odometry.dat; empty for any other name.
std::optional<std::int64_t> robot_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const auto ending = name.find(kOdometry);
  if (!name.starts_with(kRobot) || ending == std::string::npos || !has_ending(path, kOdometry)) {
    return std::nullopt;
  }
  std::int64_t number = 0;
  const char* const last = name.data() + ending;
  const auto parsed = std::from_chars(name.data() + kRobot.size(), last, number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == last && number > 0;
  return is_number ? std::optional(number) : std::nullopt;
}

std::map<std::int64_t, std::filesystem::path> odometry_files(const std::filesystem::path& folder) {
  std::error_code unreadable;
  std::map<std::int64_t, std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    if (const auto number = robot_of(entry.path())) {
      files.emplace(*number, entry.path());
    }
  }
  if (unreadable) {
    throw files::FileError(folder.string() + ": " + unreadable.message());
  }
  if (files.size() < 2) {
    throw files::FileError(folder.string() + ": not a team's logs: it has " +
                           std::to_string(files.size()) +
                           " of the files RobotN_Odometry.dat, a team has at least two");
  }
  return files;
}

std::map<std::int64_t, Eigen::Vector2d> read_landmarks(const std::filesystem::path& path) {
  std::map<std::int64_t, Eigen::Vector2d> landmarks_m;
  CompanionLines lines(path);
  while (auto next = lines.next()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    FieldCursor& fields = *next;
    const std::int64_t number = fields.integer("the landmark");
    const double x_m = fields.number("x");
    const double y_m = fields.number("y");
    fields.number("the deviation of x");
    fields.number("the deviation of y");
    fields.expect_end();
    landmarks_m[number] = {x_m, y_m};
    if (landmarks_m.size() > kMaxLandmarks) {
      fields.fail("the landmark", std::to_string(number), "one of too many");
    }
  }
  return landmarks_m;
}

/// Takes the records of one robot, with the stamps of when they were true.
class RobotRecords {
 public:
  RobotRecords(std::int64_t robot, const MrclamTiming& timing, TeamLog& team)
      : robot_(robot), timing_(timing), team_(team) {}

  void take(const LogRecord& record) {
    const auto stamp_s = datasets::stamp_s(record);
    if (const auto* seen = std::get_if<LandmarkSighting>(&record)) {
      // One picture shows several barcodes: the first has its stamp.
      picture_s_ = stamp_s ? stamp_s : picture_s_;
      put(picture_s_, -timing_.picture_age_s, *seen);
    } else if (const auto* step = std::get_if<OdometryStep>(&record)) {
      put(stamp_s, timing_.command_lag_s, as_driven(*step));
    } else if (const auto* given = std::get_if<GivenPose>(&record)) {
      put(stamp_s, 0.0, *given);
    }
  }

 private:
  template <typename Record>
  void put(std::optional<double> stamp_s, double later_s, const Record& record) {
    if (stamp_s) {
      team_.records.push_back({*stamp_s + later_s, robot_, record});
    }
  }
  OdometryStep as_driven(const OdometryStep& commanded) const {
    const geometry::Pose2& step = commanded.T_last_now;
    return {commanded.stamp_s,
            geometry::Pose2(timing_.drive_share * step.x_m(),
                            timing_.drive_share * step.y_m(),
                            timing_.turn_share * step.heading_rad())};
  }

  std::int64_t robot_;
  const MrclamTiming& timing_;
  TeamLog& team_;
  std::optional<double> picture_s_;
};

void read_robot(std::int64_t robot,
                const std::filesystem::path& path,
                const MrclamTiming& timing,
                TeamLog& team) {
  RobotRecords records(robot, timing, team);
  const auto log = open_mrclam_log(path);
  try {
    while (const auto record = log->next()) {
      records.take(*record);
    }
  } catch (const CutOffLine& half) {
    team.notes.push_back(std::string("the end of a log is incomplete; everything before it was "
                                     "read: ") +
                         half.what());
  }
  team.robots.push_back(robot);
}

}  // namespace

TeamLog read_mrclam_team(const std::filesystem::path& folder, const MrclamTiming& timing) {
  const auto files = odometry_files(folder);
  const auto& any_log = files.begin()->second;
  const std::string robot_ending =
      std::string(kRobot) + std::to_string(files.begin()->first) + std::string(kOdometry);
  TeamLog team;
  team.landmarks_m =
      read_landmarks(required_companion(any_log, robot_ending, "Landmark_Groundtruth.dat"));
  for (const auto& [robot, path] : files) {
    read_robot(robot, path, timing, team);
  }
  std::stable_sort(
      team.records.begin(),
      team.records.end(),
      [](const TeamRecord& left, const TeamRecord& right) { return left.stamp_s < right.stamp_s; });
  return team;
}

}  // namespace echomap::datasets
