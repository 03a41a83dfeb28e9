// SPDX-License-Identifier: MIT
#include "host/datasets/breezyslam_log.hpp"

#include <numbers>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/datasets/wheel_counter.hpp"

namespace echomap::datasets {
namespace {

constexpr double kMetresPerTick = 2.0 * std::numbers::pi * 0.077 / 2000.0;
constexpr double kTrack_m = 0.33;
constexpr double kLaserAhead_m = 0.145;
constexpr std::size_t kFieldsBeforeRanges = 24;
constexpr int kBeams = 683;
constexpr int kMargin = 70;
constexpr double kStep_rad = 2.0 * std::numbers::pi / 1024.0;
constexpr double kMaxRange_m = 5.6;
constexpr double kLeastRange_mm = 20.0;

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
    records.emplace_back(WheelIncrement{stamp_s,
                                        left_.increment(left_ticks) * kMetresPerTick,
                                        right_.increment(right_ticks) * kMetresPerTick,
                                        kTrack_m});
    RangeScan scan{stamp_s, {kLaserAhead_m, 0.0, 0.0}, {}, 0.0, kMaxRange_m};
    for (int i = 0; i < kBeams; ++i) {
      const double range_mm = fields.number("a range");
      if (i >= kMargin && i < kBeams - kMargin) {
        const double range_m = range_mm < kLeastRange_mm ? 0.0 : range_mm / 1000.0;
        scan.beams.push_back(
            {(i - kBeams / 2) * kStep_rad, returned_range_m(range_m, kMaxRange_m)});
      }
    }
    fields.expect_end();
    records.emplace_back(std::move(scan));
  }

 private:
  RisingStamp stamps_;
  WheelCounter left_;
  WheelCounter right_;
};

}  // namespace

std::unique_ptr<LogReader> open_breezyslam_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<BreezyslamParser>());
}

}  // namespace echomap::datasets
