// SPDX-License-Identifier: MIT
#include "host/datasets/nxt_scan_log.hpp"

#include <numbers>
#include <utility>

#include "host/datasets/field_cursor.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {
namespace {

constexpr std::size_t kMaxRanges = 3600;
constexpr double kBeamWidthDeg = 30.0;
constexpr double kMaxRangeM = 2.55;

/// The scan is known when the whole file has been read.
class NxtScanLog : public LogReader {
 public:
  explicit NxtScanLog(const std::filesystem::path& path) : lines_(path) {}

  std::optional<LogRecord> next() override {
    sensors::RangeScan scan{{}, {}, {}, geometry::radians(kBeamWidthDeg), kMaxRangeM};
    while (const auto line = lines_.next()) {
      FieldCursor fields(lines_, *line);
      if (fields.at_end()) {
        continue;
      }
      const double range_m = fields.number("the range") / 100.0;
      fields.expect_end();
      if (scan.beams.size() == kMaxRanges) {
        lines_.fail("more ranges than a scan has");
      }
      scan.beams.push_back({0.0, sensors::returned_range_m(range_m, kMaxRangeM)});
    }
    if (scan.beams.empty()) {
      return std::nullopt;
    }
    const double step_rad = 2.0 * std::numbers::pi / static_cast<double>(scan.beams.size());
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
      scan.beams[i].bearing_rad = geometry::wrap_angle(step_rad * static_cast<double>(i));
    }
    return scan;
  }

  double progress() const override { return lines_.progress(); }

 private:
  LineReader lines_;
};

}  // namespace

std::unique_ptr<LogReader> open_nxt_scan_log(const std::filesystem::path& path) {
  return std::make_unique<NxtScanLog>(path);
}

}  // namespace echomap::datasets
