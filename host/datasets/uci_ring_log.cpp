// SPDX-License-Identifier: MIT
#include "host/datasets/uci_ring_log.hpp"

#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr int kSonars = 24;
constexpr double kStepDeg = 15.0;
constexpr double kMaxRangeM = 5.0;

class UciRingParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    FieldCursor fields(lines, line, Separator::kComma);
    sensors::RangeScan scan{{}, {}, {}, geometry::radians(kStepDeg), kMaxRangeM};
    for (int i = 0; i < kSonars; ++i) {
      const double bearing_rad = geometry::wrap_angle(-geometry::radians(kStepDeg * i));
      scan.beams.push_back(
          {bearing_rad, sensors::returned_range_m(fields.number("a range"), kMaxRangeM)});
    }
    fields.word("the label");
    fields.expect_end();
    records.emplace_back(std::move(scan));
  }
};

}  // namespace

std::unique_ptr<LogReader> open_uci_ring_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<UciRingParser>());
}

}  // namespace echomap::datasets
