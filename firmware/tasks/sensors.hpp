// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/drivers/analog_inputs.hpp"
#include "firmware/drivers/debounced_bits.hpp"
#include "firmware/drivers/gyro.hpp"
#include "firmware/drivers/spare_pins.hpp"

namespace echomap {
namespace tasks {

/// The sensors beside wheels, sonar and contacts, and the spare pins that most of them are on.
class Sensors {
 public:
  /// `pins` and `settings` are where the active ones stand.
  constexpr Sensors(protocol::ConfigurePins& pins, protocol::ConfigureSensors& settings)
      : pins_(pins), settings_(settings) {}

  /// True when the board can do it; a gyro not while spare pins in use are those of its bus.
  bool accepts(const protocol::ConfigurePins& settings) const { return pins_.accepts(settings); }
  bool accepts(const protocol::ConfigureSensors& settings) const;
  /// Takes settings that `accepts` has granted. Pins of the bus switch the gyro off: a host that
  /// changes its profile sends the pins first.
  void configure(const protocol::ConfigurePins& settings);
  void configure(const protocol::ConfigureSensors& settings);

  /// Once a millisecond.
  void tick();

  constexpr const drivers::SparePins& pins() const { return pins_; }
  constexpr drivers::SparePins& pins() { return pins_; }
  /// Bits of protocol::Hazard.
  const drivers::DebouncedBits& hazards() const { return hazards_; }
  const drivers::AnalogInputs& analog() const { return analog_; }
  const drivers::Gyro& gyro() const { return gyro_; }

 private:
  /// True when spare pins in use are those of its bus.
  bool takes_bus_of_gyro() const;

  drivers::SparePins pins_;
  protocol::ConfigureSensors& settings_;
  drivers::DebouncedBits hazards_;
  drivers::AnalogInputs analog_;
  drivers::Gyro gyro_;
};

}  // namespace tasks
}  // namespace echomap
