// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "hil_mock/world/motor_driver.hpp"

namespace echomap::runner {

/// A pin as one word: "z" floats, "u" is pulled up by the chip alone, "0" and "1" are levels,
/// "0.25/128" is high for the first quarter of every 128 us and "~0.25/128" low for it.
std::string text_of(const world::PinSignal& pin);

/// Writes a line of CSV whenever one of the wires to the motor drivers changes: simulated
/// nanoseconds and the six wires, from the first call on.
class PinLog {
 public:
  /// Begins the file anew. Throws std::runtime_error where it cannot be written.
  explicit PinLog(const std::filesystem::path& file);

  void note(std::int64_t now_ns, const world::DriverInputs& left, const world::DriverInputs& right);

 private:
  std::ofstream lines_;
  std::optional<std::pair<world::DriverInputs, world::DriverInputs>> last_;
};

}  // namespace echomap::runner
