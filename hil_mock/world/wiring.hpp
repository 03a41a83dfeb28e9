// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::world {

/// What may be soldered to a spare pin of a robot's board; the words of [wiring] stand in
/// wiring.cpp.
enum class PinPart : std::uint8_t {
  kCliffLeft,
  kCliffFrontLeft,
  kCliffFrontRight,
  kCliffRight,
  kWheelDrop,
  kVirtualWall,
  kWall,
  kScalarPulses,
  kBattery,
  kScalarLevel,
  kRange0,
  kRange7 = kRange0 + 7,
  kStepperA,
  kStepperD = kStepperA + 3,
};

/// The parts by the names that a robot's file has for them, in the order of PinPart.
std::vector<std::string> pin_part_names();
/// Empty for a word that names none.
std::optional<PinPart> pin_part_named(std::string_view name);

/// A wire from a part to a spare pin.
struct PinWire {
  PinPart part = PinPart::kCliffLeft;
  /// Of parts that say yes or no: the level that means yes.
  bool active_high = false;
};

/// By pin, numbered as in protocol::ConfigurePins; what is not wired is empty.
using PinWires = std::array<std::optional<PinWire>, 16>;

/// The wires of a robot for each board that it may carry.
using Wiring = std::map<std::string, PinWires>;

}  // namespace echomap::world
