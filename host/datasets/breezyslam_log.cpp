// SPDX-License-Identifier: MIT
#include "host/datasets/breezyslam_log.hpp"

#include <numbers>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/datasets/wheel_counters.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr double kMetresPerTick = 2.0 * std::numbers::pi * 0.077 / 2000.0;
constexpr double kTrackM = 0.33;
constexpr double kLaserAheadM = 0.145;
constexpr std::size_t kFieldsBeforeRanges = 24;
constexpr int kBeams = 683;
constexpr int kBeamAhead = kBeams / 2;
constexpr int kMargin = 70;
constexpr double kStepRad = 2.0 * std::numbers::pi / 1024.0;
constexpr double kMaxRangeM = 5.6;
constexpr double kMinRangeMm = 20.0;

class BreezyslamParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line);
    const auto stamp_s = stamps_.accept(fields.number("the time") * 1e-6);
    fields.skip(1);
    const double left_ticks = fields.number("the left ticks");
    const double right_ticks = fields.number("the right ticks");
    fields.skip(kFieldsBeforeRanges - 4);
    records.emplace_back(wheels_.increment(stamp_s, left_ticks, right_ticks));
    sensors::RangeScan scan{stamp_s, {kLaserAheadM, 0.0, 0.0}, {}, 0.0, kMaxRangeM};
    for (int i = 0; i < kBeams; ++i) {
      const double range_mm = fields.number("a range");
      if (i >= kMargin && i < kBeams - kMargin) {
        const double range_m = range_mm < kMinRangeMm ? 0.0 : range_mm / 1000.0;
        scan.beams.push_back(
            {(i - kBeamAhead) * kStepRad, sensors::returned_range_m(range_m, kMaxRangeM)});
      }
    }
    fields.expect_end();
    records.emplace_back(std::move(scan));
  }

 private:
  RisingStamp stamps_;
  WheelCounters wheels_{kMetresPerTick, kTrackM};
};

}  // namespace

std::unique_ptr<LogReader> open_breezyslam_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<BreezyslamParser>());
}

}  // namespace echomap::datasets
