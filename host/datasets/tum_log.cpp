// SPDX-License-Identifier: MIT
#include "host/datasets/tum_log.hpp"

#include <cmath>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/rising_stamp.hpp"

namespace echomap::datasets {
namespace {

class TumParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    if (line.starts_with('#')) {
      return;
    }
    FieldCursor fields(lines, line);
    const double stamp_s = fields.number("the time");
    const double x_m = fields.number("x");
    const double y_m = fields.number("y");
    fields.number("z");
    const double qx = fields.number("qx");
    const double qy = fields.number("qy");
    const double qz = fields.number("qz");
    const double qw = fields.number("qw");
    fields.expect_end();
    const double heading_rad =
        std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
    records.emplace_back(GivenPose{stamps_.accept(stamp_s), {x_m, y_m, heading_rad}});
  }

 private:
  RisingStamp stamps_;
};

}  // namespace

std::unique_ptr<LogReader> open_tum_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<TumParser>());
}

}  // namespace echomap::datasets
