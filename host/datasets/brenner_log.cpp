// SPDX-License-Identifier: MIT
#include "host/datasets/brenner_log.hpp"

#include <utility>
#include <vector>

#include "host/datasets/companion_file.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/merged_log.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/datasets/wheel_counters.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr std::string_view kScansEnding = "_scan.txt";
constexpr double kMetresPerTick = 0.000349;
constexpr double kTrackM = 0.155;
constexpr double kScannerAheadM = 0.030;
constexpr double kBeamStepRad = 0.006135923;
constexpr double kScannerTurnRad = -0.0698132;
constexpr double kMaxRangeM = 4.0;

/// The letter that every line of a file begins with, and the time after it.
double read_time_s(FieldCursor& fields, std::string_view letter) {
  const std::string_view kind = fields.word("the kind of line");
  if (kind != letter) {
    fields.fail("the kind of line", kind, "not " + std::string(letter));
  }
  return fields.number("the time") / 1000.0;
}

class ScanParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const auto stamp_s = stamps_.accept(read_time_s(fields, "S"));
    sensors::RangeScan scan{stamp_s, {kScannerAheadM, 0.0, 0.0}, {}, 0.0, kMaxRangeM};
    scan.beams.resize(fields.count("the number of ranges"));
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
      const double range_m = fields.number("a range") / 1000.0;
      scan.beams[i] = {(static_cast<double>(i) - 330.0) * kBeamStepRad + kScannerTurnRad,
                       sensors::returned_range_m(range_m, kMaxRangeM)};
    }
    fields.expect_end();
    records.emplace_back(std::move(scan));
  }

 private:
  RisingStamp stamps_;
};

class MotorParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const auto stamp_s = stamps_.accept(read_time_s(fields, "M"));
    const double left_ticks = fields.number("the left ticks");
    fields.skip(3);
    const double right_ticks = fields.number("the right ticks");
    records.emplace_back(wheels_.increment(stamp_s, left_ticks, right_ticks));
  }

 private:
  RisingStamp stamps_;
  WheelCounters wheels_{kMetresPerTick, kTrackM};
};

class ReferenceParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const auto stamp_s = stamps_.accept(read_time_s(fields, "P"));
    const double x_m = fields.number("x") / 1000.0;
    const double y_m = fields.number("y") / 1000.0;
    fields.expect_end();
    records.emplace_back(GivenPosition{stamp_s, {x_m, y_m}});
  }

 private:
  RisingStamp stamps_;
};

}  // namespace

std::unique_ptr<LogReader> open_brenner_log(const std::filesystem::path& path) {
  const auto motors = required_companion(path, kScansEnding, "_motors.txt");
  std::vector<std::unique_ptr<LogReader>> logs;
  logs.push_back(std::make_unique<LineLog>(motors, std::make_unique<MotorParser>()));
  logs.push_back(std::make_unique<LineLog>(path, std::make_unique<ScanParser>()));
  if (const auto references = companion_file(path, kScansEnding, "_reference.txt")) {
    logs.push_back(std::make_unique<LineLog>(*references, std::make_unique<ReferenceParser>()));
  }
  return std::make_unique<MergedLog>(std::move(logs));
}

}  // namespace echomap::datasets
