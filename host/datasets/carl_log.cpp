// SPDX-License-Identifier: MIT
#include "host/datasets/carl_log.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/datasets/wheel_counters.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr double kWheelDiameterM = 0.064;
constexpr double kMetresPerDeg = kWheelDiameterM / 2.0 * geometry::radians(1.0);
constexpr double kTrackM = 0.11405;
constexpr double kMaxRangeM = 3.0;
constexpr double kBeamWidthDeg = 25.0;

/// Seconds since 1970 of YYYYMMDD-HHMMSS.mmm.
double read_time(FieldCursor& fields) {
  constexpr const char* kName = "the time";
  const std::string_view text = fields.word(kName);
  constexpr std::string_view kShape = "dddddddd-dddddd.ddd";
  bool fits = text.size() == kShape.size();
  for (std::size_t i = 0; fits && i < text.size(); ++i) {
    fits = kShape[i] == 'd' ? text[i] >= '0' && text[i] <= '9' : text[i] == kShape[i];
  }
  if (!fits) {
    fields.fail(kName, text, "not YYYYMMDD-HHMMSS.mmm");
  }
  const auto part = [text](std::size_t begin, std::size_t count) {
    int value = 0;
    for (const char digit : text.substr(begin, count)) {
      value = 10 * value + (digit - '0');
    }
    return value;
  };
  const std::chrono::year_month_day day{std::chrono::year(part(0, 4)),
                                        std::chrono::month(static_cast<unsigned>(part(4, 2))),
                                        std::chrono::day(static_cast<unsigned>(part(6, 2)))};
  if (!day.ok()) {
    fields.fail(kName, text, "not a day of the calendar");
  }
  const auto days = static_cast<double>(std::chrono::sys_days(day).time_since_epoch().count());
  return days * 86400.0 + part(9, 2) * 3600.0 + part(11, 2) * 60.0 + part(13, 2) +
         part(16, 3) / 1000.0;
}

class CarlParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    if (lines.line_number() == 1 && line.starts_with("timestr")) {
      return;
    }
    FieldCursor fields(lines, line, Separator::kComma);
    const auto stamp_s = stamps_.accept(read_time(fields));
    const double left_deg = fields.number("the left encoder");
    const double right_deg = fields.number("the right encoder");
    const double clockwise_deg = fields.number("the heading");
    const double pan_clockwise_deg = fields.number("the pan");
    const double range_m = fields.number("the range") / 1000.0;
    fields.expect_end();

    records.emplace_back(Heading{stamp_s, geometry::wrap_angle(-geometry::radians(clockwise_deg))});
    records.emplace_back(wheels_.increment(stamp_s, left_deg, right_deg));
    sensors::RangeScan scan{stamp_s, {}, {}, geometry::radians(kBeamWidthDeg), kMaxRangeM};
    scan.is_light = true;
    scan.beams = {
        {-geometry::radians(pan_clockwise_deg), sensors::returned_range_m(range_m, kMaxRangeM)}};
    records.emplace_back(std::move(scan));
  }

 private:
  RisingStamp stamps_;
  WheelCounters wheels_{kMetresPerDeg, kTrackM};
};

}  // namespace

std::unique_ptr<LogReader> open_carl_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<CarlParser>());
}

}  // namespace echomap::datasets
