// SPDX-License-Identifier: MIT
#include "host/datasets/roomba_ci_log.hpp"

#include <cstdint>
#include <limits>
#include <numbers>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_log.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/tick_unwrapper.hpp"

namespace echomap::datasets {
namespace {

constexpr double kMetresPerTick = std::numbers::pi * 0.072 / 508.8;
constexpr double kTrackM = 0.235;
/// A Roomba is 34 cm across (iRobot Create 2 Open Interface, 2016).
constexpr double kBumperRadiusM = 0.17;
constexpr unsigned kBumpRight = 1;
constexpr unsigned kBumpLeft = 2;

/// A wheel's counter through its wraps.
class WrappingCounter {
 public:
  /// What the wheel has rolled since the reading before; zero at the first.
  double increment_m(FieldCursor& fields, const char* name) {
    const std::int64_t reading = fields.integer(name);
    if (reading < std::numeric_limits<std::int16_t>::min() ||
        reading > std::numeric_limits<std::int16_t>::max()) {
      fields.fail(name, std::to_string(reading), "more than 16 bits hold");
    }
    const std::int64_t ticks = unwrapper_.unwrap(static_cast<std::int16_t>(reading));
    const auto step_ticks = static_cast<double>(ticks - last_ticks_);
    last_ticks_ = ticks;
    return step_ticks * kMetresPerTick;
  }

 private:
  sensors::TickUnwrapper unwrapper_;
  std::int64_t last_ticks_ = 0;
};

unsigned read_bits(FieldCursor& fields, const char* name) {
  constexpr std::size_t kDigits = 8;
  const std::string_view text = fields.word(name);
  if (text.size() != kDigits || text.find_first_not_of("01") != std::string_view::npos) {
    fields.fail(name, text, "not eight binary digits");
  }
  unsigned bits = 0;
  for (const char digit : text) {
    bits = 2 * bits + (digit == '1' ? 1U : 0U);
  }
  return bits;
}

class RoombaCiParser : public LineParser {
 public:
  void parse(const LineReader& lines,
             std::string_view line,
             std::vector<LogRecord>& records) override {
    if (lines.line_number() == 1 && line.starts_with("Time Stamp,")) {
      has_header_ = true;
      return;
    }
    if (!has_header_ && line.ends_with(';')) {
      line.remove_suffix(1);
    }
    FieldCursor fields(lines, line, Separator::kComma);
    const auto stamp_s = stamps_.accept(fields.number("the time"));
    fields.skip(has_header_ ? 4 : 0);
    const double left_m = left_.increment_m(fields, "the left encoder");
    const double right_m = right_.increment_m(fields, "the right encoder");
    if (!has_header_) {
      const double clockwise_rad = geometry::radians(fields.number("the heading"));
      records.emplace_back(Heading{stamp_s, geometry::wrap_angle(-clockwise_rad)});
    }
    fields.skip(has_header_ ? 4 : 0);
    const unsigned bumpers = read_bits(fields, "the bumper byte");
    fields.skip(has_header_ ? 1 : 7);
    fields.expect_end();
    records.emplace_back(WheelIncrement{stamp_s, left_m, right_m, kTrackM});
    records.emplace_back(
        Contact{stamp_s, (bumpers & kBumpLeft) != 0, (bumpers & kBumpRight) != 0, kBumperRadiusM});
  }

 private:
  bool has_header_ = false;
  RisingStamp stamps_;
  WrappingCounter left_;
  WrappingCounter right_;
};

}  // namespace

std::unique_ptr<LogReader> open_roomba_ci_log(const std::filesystem::path& path) {
  return std::make_unique<LineLog>(path, std::make_unique<RoombaCiParser>());
}

}  // namespace echomap::datasets
