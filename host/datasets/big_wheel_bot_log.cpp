// SPDX-License-Identifier: MIT
#include "host/datasets/big_wheel_bot_log.hpp"

#include <numbers>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr double kMetresPerTick = 0.005;
constexpr double kTrackM = 0.19;
constexpr double kSonarMaxRangeM = 5.0;
constexpr double kSonarBeamWidthDeg = 30.0;
constexpr double kInfraredMaxRangeM = 0.6;
constexpr double kInfraredBearingDeg = 45.0;

std::optional<double> read_range_m(FieldCursor& fields, const char* name, double max_range_m) {
  return sensors::returned_range_m(fields.number(name) / 100.0, max_range_m);
}

class BigWheelBotParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line, Separator::kComma);
    const double left_m = fields.number("the left ticks") * kMetresPerTick;
    const double right_m = fields.number("the right ticks") * kMetresPerTick;
    const double clockwise_rad = geometry::radians(fields.number("the yaw"));
    records.emplace_back(Heading{{}, geometry::wrap_angle(-clockwise_rad)});
    records.emplace_back(WheelIncrement{{}, left_m, right_m, kTrackM});

    sensors::RangeScan sonar{{}, {}, {}, geometry::radians(kSonarBeamWidthDeg), kSonarMaxRangeM};
    sonar.beams = {{0.0, read_range_m(fields, "the front range", kSonarMaxRangeM)},
                   {std::numbers::pi, read_range_m(fields, "the rear range", kSonarMaxRangeM)}};
    records.emplace_back(std::move(sonar));

    const double side_rad = geometry::radians(kInfraredBearingDeg);
    sensors::RangeScan infrared{{}, {}, {}, 0.0, kInfraredMaxRangeM};
    infrared.beams = {{side_rad, read_range_m(fields, "the left IR range", kInfraredMaxRangeM)},
                      {-side_rad, read_range_m(fields, "the right IR range", kInfraredMaxRangeM)}};
    records.emplace_back(std::move(infrared));
    fields.number("the first servo");
    fields.number("the second servo");
    fields.expect_end();
  }
};

}  // namespace

std::unique_ptr<LogReader> open_big_wheel_bot_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<BigWheelBotParser>());
}

}  // namespace echomap::datasets
