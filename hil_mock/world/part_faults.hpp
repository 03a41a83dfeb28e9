// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::world {

/// What may be wrong with a part of a robot.
enum class PartFaultKind : std::uint8_t {
  kEncoderLeft,           ///< Its pins stand still, however the wheel turns.
  kEncoderRight,          ///< The same of the right one.
  kSonarDead,             ///< It answers no trigger.
  kSonarStuck,            ///< Every ping is answered from `value` metres.
  kSlipLeft,              ///< The wheel loses the share `value` of what it rolls, 0 .. 1.
  kSlipRight,             ///< The same of the right one.
  kBatteryLow,            ///< It has no more than the share `value` of its charge, 0 .. 1.
  kBoardReset,            ///< It is reset, and its boot loader hears and says nothing.
  kMotorLeftReversed,     ///< It turns the other way than the board drives it.
  kMotorRightReversed,    ///< The same of the right one.
  kEncoderLeftReversed,   ///< Its pins are swapped: it counts the other way.
  kEncoderRightReversed,  ///< The same of the right one.
  kMotorsSwapped,         ///< Each wheel is driven by the other one's output.
  kEncodersSwapped,       ///< Each wheel is counted by the other one's input.
  kCounts,                ///< Both encoders give `value` times the edges of the robot's file.
  kWheelLeft,             ///< The wheel rolls `value` times as far as that of the robot's file.
  kWheelRight,            ///< The same of the right one.
  kPanReversed,           ///< The pan turns the other way than its pulses ask.
  kPanOff,                ///< Its zero is `value` degrees to the left.
  kEncoderLeftDirty,      ///< The share `value` of its edges comes only with the next one.
  kEncoderRightDirty,     ///< The same of the right one.
  kSonarHigh,             ///< Its echo line rises with the next ping and does not fall.
  kSonarSlow,             ///< A ping that nothing answers holds its echo line for `value` seconds.
  kContactLeftBroken,     ///< The wire of the left bump contact: the board finds it open.
  kContactRightBroken,    ///< The same of the right one.
  kRangeScale,            ///< An echo comes after `value` times the time of its range.
};

/// One fault, from `at_s` of simulated time on.
struct PartFault {
  PartFaultKind kind = PartFaultKind::kSonarDead;
  double at_s = 0.0;
  double for_s = std::numeric_limits<double>::infinity();
  double value = 0.0;
};

/// Reads "NAME@AT[:FOR[:VALUE]]" with commas between, as in "sonar-dead@30,slip-left@20:2:0.3". FOR
/// may be "inf", which it is without, but for a board's second of boot loader. Names are those that
/// `name_of` gives. An empty text is no fault. Throws std::invalid_argument that says what is
/// wrong.
std::vector<PartFault> parse_part_faults(const std::string& text);

/// "encoder-left", "sonar-dead", "board-reset", ...
std::string_view name_of(PartFaultKind kind);

/// The names of all kinds, in their order.
std::vector<std::string> part_fault_names();

/// The value of a fault of this kind that there is at this time; empty where there is none.
std::optional<double> fault_at(const std::vector<PartFault>& faults,
                               PartFaultKind kind,
                               double now_s);

}  // namespace echomap::world
