// SPDX-License-Identifier: MIT
#include "host/exports/observations_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/exports/number_table.hpp"

namespace echomap::exports {
namespace {

constexpr std::string_view kHeader = "kind,stamp_us,values";
/// The range of a ping that the sonar did not answer.
constexpr std::string_view kSilent = "silent";

/// Over three thousand years: no clock counts so many, and sums of them still fit.
constexpr std::int64_t kLargestStampUs = 100'000'000'000'000'000;
/// Between two lines; a map as large as a damaged number would not fit into memory.
constexpr double kLongestStepM = 100.0;
constexpr double kLongestRangeM = 1000.0;
constexpr double kMaxM = 1000.0;

/// Reads the lines of one file.
class Replay {
 public:
  Replay(const std::filesystem::path& path, pipeline::ObservationSink& sink)
      : lines_(path), sink_(sink) {}

  /// Whether the last line lacks its end.
  bool run() {
    const auto header = lines_.next();
    if (!header || *header != kHeader) {
      lines_.fail("expected the header '" + std::string(kHeader) + "'");
    }
    while (const auto line = lines_.next()) {
      if (lines_.lacks_end()) {
        return true;
      }
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      datasets::FieldCursor fields(lines_, *line, datasets::Separator::kComma);
      hand_on(fields);
    }
    return false;
  }

 private:
  struct Kind {
    std::string_view name;
    void (Replay::*hand_on)(datasets::FieldCursor& fields);
  };
  static const std::array<Kind, 8> kKinds;

  void hand_on(datasets::FieldCursor& fields) {
    const std::string_view name = fields.word("the kind");
    const auto kind = std::find_if(
        kKinds.begin(), kKinds.end(), [&](const Kind& one) { return one.name == name; });
    if (kind == kKinds.end()) {
      fields.fail("the kind", name, "not an observation that a run records");
    }
    (this->*kind->hand_on)(fields);
  }

  void odometry(datasets::FieldCursor& fields) {
    const auto stamp = read_stamp(fields);
    const auto travel = read_travel(fields);
    fields.expect_end();
    sink_.on_odometry({stamp, travel});
  }

  void sonar(datasets::FieldCursor& fields) {
    const auto stamp = read_stamp(fields);
    const auto travel = read_travel(fields);
    const double pan_rad = fields.number("the pan angle");
    const bool has_answered = !fields.skip_word(kSilent);
    const auto range_m = has_answered ? read_range_m(fields) : std::nullopt;
    fields.expect_end();
    sink_.on_sonar({stamp, travel, pan_rad, range_m, has_answered});
  }

  void infrared(datasets::FieldCursor& fields) {
    sensors::InfraredObservation observation{read_stamp(fields), read_travel(fields), {}};
    while (!fields.at_end()) {
      observation.range_m.push_back(read_range_m(fields));
    }
    sink_.on_infrared(observation);
  }

  void hazards(datasets::FieldCursor& fields) {
    sensors::HazardObservation observation;
    observation.stamp = read_stamp(fields);
    observation.bump_left = read_flag(fields);
    observation.bump_right = read_flag(fields);
    for (bool& cliff : observation.cliffs) {
      cliff = read_flag(fields);
    }
    observation.lifted = read_flag(fields);
    observation.virtual_wall = read_flag(fields);
    observation.wall = read_flag(fields);
    fields.expect_end();
    sink_.on_hazards(observation);
  }

  void carried(datasets::FieldCursor& fields) {
    const auto stamp = read_stamp(fields);
    const auto travel = read_travel(fields);
    const auto T_map_robot = read_pose(fields);
    fields.expect_end();
    sink_.on_carried({stamp, travel, T_map_robot});
  }

  void fix(datasets::FieldCursor& fields) {
    const auto stamp = read_stamp(fields);
    const auto T_map_robot = read_pose(fields);
    fields.expect_end();
    sink_.on_pose_fix({stamp, T_map_robot});
  }

  void begin_scan(datasets::FieldCursor& fields) {
    fields.expect_end();
    sink_.begin_scan();
  }

  void end_scan(datasets::FieldCursor& fields) {
    fields.expect_end();
    sink_.end_scan();
  }

  geometry::Pose2 read_pose(datasets::FieldCursor& fields) const {
    const double x_m = read_place_m(fields);
    const double y_m = read_place_m(fields);
    return {x_m, y_m, fields.number("the heading")};
  }

  time::RobotTime read_stamp(datasets::FieldCursor& fields) const {
    const std::int64_t stamp_us = fields.integer("the stamp");
    if (stamp_us < -kLargestStampUs || stamp_us > kLargestStampUs) {
      lines_.fail("outside the range of microseconds");
    }
    return time::RobotTime(time::RobotClock::duration(stamp_us));
  }

  sensors::WheelTravel read_travel(datasets::FieldCursor& fields) {
    const double left_m = fields.number("the left wheel");
    const double right_m = fields.number("the right wheel");
    const double step_m =
        std::max(std::abs(left_m - travel_.left_m), std::abs(right_m - travel_.right_m));
    if (step_m > kLongestStepM) {
      lines_.fail("a wheel has rolled more than 100 m since the line before");
    }
    travel_ = {left_m, right_m};
    return travel_;
  }

  std::optional<double> read_range_m(datasets::FieldCursor& fields) const {
    const auto range_m = fields.number_or_none("the range");
    if (range_m && std::abs(*range_m) > kLongestRangeM) {
      lines_.fail("longer than a sensor reaches");
    }
    return range_m;
  }

  double read_place_m(datasets::FieldCursor& fields) const {
    const double place_m = fields.number("the place");
    if (std::abs(place_m) > kMaxM) {
      lines_.fail("longer than a robot can be carried");
    }
    return place_m;
  }

  bool read_flag(datasets::FieldCursor& fields) const {
    const std::int64_t flag = fields.integer("a flag");
    if (flag != 0 && flag != 1) {
      lines_.fail("a flag is neither 0 nor 1");
    }
    return flag == 1;
  }

  datasets::LineReader lines_;
  pipeline::ObservationSink& sink_;
  sensors::WheelTravel travel_;  ///< Of the line before.
};

const std::array<Replay::Kind, 8> Replay::kKinds{{
    {"odometry", &Replay::odometry},
    {"sonar", &Replay::sonar},
    {"infrared", &Replay::infrared},
    {"hazards", &Replay::hazards},
    {"carried", &Replay::carried},
    {"fix", &Replay::fix},
    {"begin-scan", &Replay::begin_scan},
    {"end-scan", &Replay::end_scan},
}};

}  // namespace

ObservationRecorder::ObservationRecorder() : text_(std::string(kHeader) + '\n') {}

void ObservationRecorder::on_odometry(const sensors::OdometryObservation& observation) {
  begin_line("odometry", observation.stamp, observation.travel);
  text_ += '\n';
}

void ObservationRecorder::on_sonar(const sensors::SonarObservation& observation) {
  begin_line("sonar", observation.stamp, observation.travel);
  add(observation.pan_rad);
  if (observation.has_answered) {
    add(observation.range_m);
  } else {
    text_ += ',';
    text_ += kSilent;
  }
  text_ += '\n';
}

void ObservationRecorder::on_infrared(const sensors::InfraredObservation& observation) {
  begin_line("infrared", observation.stamp, observation.travel);
  for (const auto& range_m : observation.range_m) {
    add(range_m);
  }
  text_ += '\n';
}

void ObservationRecorder::on_hazards(const sensors::HazardObservation& observation) {
  begin_line("hazards", observation.stamp);
  const auto& cliffs = observation.cliffs;
  for (const bool flag : {observation.bump_left,
                          observation.bump_right,
                          cliffs[0],
                          cliffs[1],
                          cliffs[2],
                          cliffs[3],
                          observation.lifted,
                          observation.virtual_wall,
                          observation.wall}) {
    text_ += flag ? ",1" : ",0";
  }
  text_ += '\n';
}

void ObservationRecorder::on_carried(const sensors::CarriedObservation& observation) {
  begin_line("carried", observation.stamp, observation.travel);
  add(observation.T_map_robot);
  text_ += '\n';
}

void ObservationRecorder::on_pose_fix(const sensors::PoseFixObservation& observation) {
  begin_line("fix", observation.stamp);
  add(observation.T_map_robot);
  text_ += '\n';
}

void ObservationRecorder::begin_scan() { text_ += "begin-scan\n"; }

void ObservationRecorder::end_scan() { text_ += "end-scan\n"; }

std::string_view ObservationRecorder::lines() const {
  return std::string_view(text_).substr(kHeader.size() + 1);
}

void ObservationRecorder::begin_line(std::string_view kind, time::RobotTime stamp) {
  text_ += kind;
  text_ += ',' + std::to_string(stamp.time_since_epoch().count());
}

void ObservationRecorder::begin_line(std::string_view kind,
                                     time::RobotTime stamp,
                                     const sensors::WheelTravel& travel) {
  begin_line(kind, stamp);
  add(travel.left_m);
  add(travel.right_m);
}

void ObservationRecorder::add(double value) {
  text_ += ',';
  append_number(text_, value);
}

void ObservationRecorder::add(const geometry::Pose2& pose) {
  add(pose.x_m());
  add(pose.y_m());
  add(pose.heading_rad());
}

void ObservationRecorder::add(const std::optional<double>& value) {
  if (value) {
    add(*value);
  } else {
    text_ += ",none";
  }
}

bool replay_observations_csv(const std::filesystem::path& path, pipeline::ObservationSink& sink) {
  try {
    return Replay(path, sink).run();
  } catch (const datasets::CutOffLine&) {
    return true;  // Zero bytes, as a loss of power leaves them.
  }
}

}  // namespace echomap::exports
