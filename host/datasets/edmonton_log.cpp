// SPDX-License-Identifier: MIT
#include "host/datasets/edmonton_log.hpp"

#include <optional>
#include <utility>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/pose_fields.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr std::string_view kScansEnding = "_LASER.txt";
constexpr std::size_t kBeams = 180;
constexpr double kMaxRangeM = 30.0;

class EdmontonParser : public LineParser {
 public:
  explicit EdmontonParser(const std::filesystem::path& path)
      : steps_(required_companion(path, kScansEnding, "_ODO.txt")) {
    if (const auto times = companion_file(path, kScansEnding, "_TIME_interp.txt")) {
      times_.emplace(*times);
    }
    if (const auto references = companion_file(path, kScansEnding, "_REF.txt")) {
      references_.emplace(*references);
      read_reference();
    }
  }

  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    sensors::RangeScan scan = read_scan(FieldCursor(lines, line));
    if (times_) {
      scan.stamp_s = stamps_.accept(times_->require(lines).number("the time"));
    }
    if (T_last_now_) {
      records.emplace_back(OdometryStep{scan.stamp_s, *T_last_now_});
    }
    FieldCursor step = steps_.require(lines);
    T_last_now_ = read_pose(step, "the increment");
    step.expect_end();
    if (reference_ && reference_->first == scans_) {
      records.emplace_back(GivenPose{scan.stamp_s, reference_->second});
      read_reference();
    }
    records.emplace_back(std::move(scan));
    ++scans_;
  }

 private:
  static sensors::RangeScan read_scan(FieldCursor fields) {
    sensors::RangeScan scan;
    scan.max_range_m = kMaxRangeM;
    scan.beams.reserve(kBeams);
    for (std::size_t i = 0; i < kBeams; ++i) {
      scan.beams.push_back({geometry::radians(static_cast<double>(i) - 90.0),
                            sensors::returned_range_m(fields.number("a range"), kMaxRangeM)});
    }
    fields.expect_end();
    return scan;
  }

  /// The next scan that has a reference pose, and the pose.
  void read_reference() {
    reference_.reset();
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): called only where there are references
    if (auto fields = references_->next()) {
      const auto scan = fields->integer("the index of the scan");
      reference_.emplace(scan, read_pose(*fields, "the reference pose"));
    }
  }

  CompanionLines steps_;
  std::optional<CompanionLines> times_;
  std::optional<CompanionLines> references_;
  std::optional<std::pair<std::int64_t, geometry::Pose2>> reference_;
  /// The increment of the line before, which leads to the scan of this one.
  std::optional<geometry::Pose2> T_last_now_;
  RisingStamp stamps_;
  std::int64_t scans_ = 0;
};

}  // namespace

std::unique_ptr<LogReader> open_edmonton_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<EdmontonParser>(path));
}

}  // namespace echomap::datasets
