// SPDX-License-Identifier: MIT
#include "host/session/motor_driver_profile.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "host/boards/boards.hpp"
#include "host/files/nearest_word.hpp"

namespace echomap::session {
namespace {

using protocol::MotorBridgeKind;

constexpr std::uint8_t kFastPwm = 0;

struct MotorDriver {
  std::string_view name;
  MotorBridgeKind kind;
  std::uint8_t options = kFastPwm;
};

/// The names that people read on their boards. Bipolar transistors (L293D) and the MX1508, whose
/// sheet gives no limit, get the slow PWM.
constexpr std::array kMotorDrivers{
    MotorDriver{"phase-enable", MotorBridgeKind::kPhaseEnable},
    MotorDriver{"drv8835", MotorBridgeKind::kPhaseEnable},  // MODE high.
    MotorDriver{"tb6612fng", MotorBridgeKind::kIn1In2Pwm},
    MotorDriver{"l298n", MotorBridgeKind::kIn1In2Pwm},
    MotorDriver{"l293d", MotorBridgeKind::kIn1In2Pwm, protocol::kSlowPwm},
    MotorDriver{"drv8833", MotorBridgeKind::kTwoPwm},
    MotorDriver{"drv8835-in-in", MotorBridgeKind::kTwoPwm},  // MODE low.
    MotorDriver{"mdd3a", MotorBridgeKind::kTwoPwm},
    MotorDriver{"mx1508", MotorBridgeKind::kTwoPwm, protocol::kSlowPwm},
    MotorDriver{"servo", MotorBridgeKind::kServo}};

std::string in_lower_case(std::string text) {
  std::ranges::transform(
      text, text.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return text;
}

const MotorDriver& find_driver(const files::TomlReader& drive) {
  const std::string word = drive.text_or("driver", kMotorDrivers.front().name);
  const auto* const found = std::ranges::find(kMotorDrivers, word, &MotorDriver::name);
  if (found == kMotorDrivers.end()) {
    std::vector<std::string> names;
    names.reserve(kMotorDrivers.size());
    for (const MotorDriver& one : kMotorDrivers) {
      names.emplace_back(one.name);
    }
    drive.fail(
        "driver",
        "no motor driver is called '" + word + "'" + files::suggestion(in_lower_case(word), names));
  }
  return *found;
}

/// The option for a duty of 0.
std::uint8_t read_stop(const files::TomlReader& drive, const MotorDriver& driver) {
  if (!drive.has("stop")) {
    return 0;
  }
  const std::string stop = drive.text("stop");
  if (stop != "coast" && stop != "brake") {
    drive.fail("stop",
               "'stop' must be \"coast\" or \"brake\", not '" + stop + "'" +
                   files::suggestion(in_lower_case(stop), {"coast", "brake"}));
  }
  if (driver.kind == MotorBridgeKind::kPhaseEnable) {
    drive.fail(
        "stop",
        "'stop' cannot be chosen with a " + std::string(driver.name) +
            ": its chip decides what it does at duty 0 (a DRV8835 brakes); leave 'stop' out");
  }
  return stop == "brake" ? std::uint8_t{protocol::kBrakeAtZero} : std::uint8_t{0};
}

}  // namespace

void read_motor_driver(const files::TomlReader& drive, protocol::ConfigureWiring& wiring) {
  const MotorDriver& driver = find_driver(drive);
  wiring.bridge = static_cast<std::uint8_t>(driver.kind);
  wiring.bridge_options = static_cast<std::uint8_t>(driver.options | read_stop(drive, driver));
}

std::string advice_on_refused_bridge(const protocol::ConfigureWiring& wiring) {
  const auto kind = static_cast<MotorBridgeKind>(wiring.bridge);
  if (kind == MotorBridgeKind::kServo) {
    return "it has no timer left for servos as wheels\n"
           "  next: use another board, " +
           boards::boards_that_carry(kind) +
           ", or a motor driver, and name it in the profile: driver = \"tb6612fng\" in [drive]";
  }
  return "the driver's second inputs need pins that [wiring] gives away, or the board lacks them\n"
         "  next: free pin_0 and pin_1 (D11, D12) of an Uno or Nano, pin_11 and pin_12 (B12, B13) "
         "of an STM32F103, pin_9 and pin_10 (GP11, GP13) of a Pico; an EV3 has no driver but its "
         "own: leave 'driver' out";
}

}  // namespace echomap::session
