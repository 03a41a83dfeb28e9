// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/drivers/analog_inputs.hpp"
#include "firmware/drivers/debounced_bits.hpp"
#include "firmware/drivers/gyro.hpp"
#include "firmware/drivers/scalar_sensor.hpp"
#include "firmware/drivers/spare_pins.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace tasks {

/// The sensors beside wheels, sonar and contacts, and the spare pins that most of them are on.
class Sensors {
 public:
  /// All three are where the active ones stand.
  constexpr Sensors(protocol::ConfigurePins& pins,
                    protocol::ConfigureSensors& settings,
                    protocol::ConfigureScalar& scalar)
      : pins_(pins), settings_(settings), scalar_settings_(scalar) {}

  /// True when the board can do it; a gyro not while spare pins in use are those of its bus.
  bool accepts(const protocol::ConfigurePins& settings) const { return pins_.accepts(settings); }
  bool accepts(const protocol::ConfigureSensors& settings) const;
  static bool accepts(const protocol::ConfigureScalar& settings) {
    return settings.period_ms <= protocol::kMaxScalarPeriodMs;
  }
  /// Takes settings that `accepts` has granted. Pins of the bus switch the gyro off: a host that
  /// changes its profile sends the pins first.
  void configure(const protocol::ConfigurePins& settings);
  void configure(const protocol::ConfigureSensors& settings);
  void configure(const protocol::ConfigureScalar& settings) { scalar_settings_ = settings; }

  /// Once a millisecond.
  void tick();

  constexpr const drivers::SparePins& pins() const { return pins_; }
  constexpr drivers::SparePins& pins() { return pins_; }
  /// Bits of protocol::Hazard.
  const drivers::DebouncedBits& hazards() const { return hazards_; }
  const drivers::AnalogInputs& analog() const { return analog_; }
  const drivers::Gyro& gyro() const { return gyro_; }
  const drivers::ScalarSensor& scalar() const { return scalar_; }

 private:
  /// True when spare pins in use are those of its bus.
  bool takes_bus_of_gyro() const;

  drivers::SparePins pins_;
  protocol::ConfigureSensors& settings_;
  protocol::ConfigureScalar& scalar_settings_;
  drivers::DebouncedBits hazards_;
  drivers::AnalogInputs analog_;
  drivers::Gyro gyro_;
  drivers::ScalarSensor scalar_;
};

}  // namespace tasks
}  // namespace echomap
