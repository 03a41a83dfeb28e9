// SPDX-License-Identifier: MIT
#include "host/datasets/mrclam_log.hpp"

#include <map>
#include <utility>
#include <vector>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/merged_log.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/sensors/odometry.hpp"

namespace echomap::datasets {
namespace {

constexpr std::string_view kOdometryEnding = "_Odometry.dat";

/// Lines that begin with # are comments in every file of the set.
class MrclamParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) final {
    if (!line.starts_with('#')) {
      FieldCursor fields(lines, line);
      parse_fields(fields, records);
      fields.expect_end();
    }
  }

 private:
  virtual void parse_fields(FieldCursor& fields, std::vector<LogRecord>& records) = 0;
};

class SpeedParser : public MrclamParser {
 private:
  void parse_fields(FieldCursor& fields, std::vector<LogRecord>& records) override {
    const double time_s = fields.number("the time");
    const auto stamp_s = stamps_.accept(time_s);
    const double duration_s = stamp_s && started_ ? time_s - last_s_ : 0.0;
    records.emplace_back(OdometryStep{
        stamp_s, sensors::arc_step(speed_m_per_s_ * duration_s, turn_rad_per_s_ * duration_s)});
    last_s_ = stamp_s.value_or(last_s_);
    started_ = true;
    speed_m_per_s_ = fields.number("the speed");
    turn_rad_per_s_ = fields.number("the turn rate");
  }

  RisingStamp stamps_;
  bool started_ = false;
  double last_s_ = 0.0;
  double speed_m_per_s_ = 0.0;
  double turn_rad_per_s_ = 0.0;
};

class SightingParser : public MrclamParser {
 public:
  explicit SightingParser(std::map<std::int64_t, std::int64_t> subject_of_barcode)
      : subject_of_barcode_(std::move(subject_of_barcode)) {}

 private:
  void parse_fields(FieldCursor& fields, std::vector<LogRecord>& records) override {
    const auto stamp_s = stamps_.accept(fields.number("the time"));
    const auto subject = subject_of_barcode_.find(fields.integer("the barcode"));
    const double range_m = fields.number("the range");
    const double bearing_rad = fields.number("the bearing");
    if (subject != subject_of_barcode_.end()) {
      records.emplace_back(LandmarkSighting{stamp_s, subject->second, range_m, bearing_rad});
    }
  }

  std::map<std::int64_t, std::int64_t> subject_of_barcode_;
  /// One picture shows several barcodes under one stamp: the first has it.
  RisingStamp stamps_;
};

class TruthParser : public MrclamParser {
 private:
  void parse_fields(FieldCursor& fields, std::vector<LogRecord>& records) override {
    const auto stamp_s = stamps_.accept(fields.number("the time"));
    records.emplace_back(GivenPose{stamp_s, read_pose(fields, "the pose")});
  }

  RisingStamp stamps_;
};

std::map<std::int64_t, std::int64_t> read_barcodes(const std::filesystem::path& path) {
  constexpr std::size_t kMaxSubjects = 1000;
  std::map<std::int64_t, std::int64_t> subject_of_barcode;
  CompanionLines lines(path);
  while (auto fields = lines.next()) {
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    const std::int64_t subject = fields->integer("the subject");
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    const std::int64_t barcode = fields->integer("the barcode");
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
    fields->expect_end();
    subject_of_barcode[barcode] = subject;
    if (subject_of_barcode.size() > kMaxSubjects) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      fields->fail("the barcode", std::to_string(barcode), "one of too many");
    }
  }
  return subject_of_barcode;
}

/// Barcodes.dat, which all robots share.
std::filesystem::path barcodes_beside(const std::filesystem::path& path) {
  const std::filesystem::path plain = path.parent_path() / "Barcodes.dat";
  const std::filesystem::path packed = plain.string() + ".gz";
  return !std::filesystem::exists(plain) && std::filesystem::exists(packed) ? packed : plain;
}

}  // namespace

std::unique_ptr<LogReader> open_mrclam_log(const std::filesystem::path& path) {
  const auto sightings = required_companion(path, kOdometryEnding, "_Measurement.dat");
  const auto truth = companion_file(path, kOdometryEnding, "_Groundtruth.dat");
  auto barcodes = read_barcodes(barcodes_beside(path));
  std::vector<std::unique_ptr<LogReader>> logs;
  logs.push_back(std::make_unique<LineLog>(path, std::make_unique<SpeedParser>()));
  logs.push_back(
      std::make_unique<LineLog>(sightings, std::make_unique<SightingParser>(std::move(barcodes))));
  if (truth) {
    logs.push_back(std::make_unique<LineLog>(*truth, std::make_unique<TruthParser>()));
  }
  return std::make_unique<MergedLog>(std::move(logs));
}

}  // namespace echomap::datasets
