// SPDX-License-Identifier: MIT
#include "firmware/tasks/sensors.hpp"

namespace echomap {
namespace tasks {

bool Sensors::accepts(const protocol::ConfigureSensors& settings) const {
  return drivers::GyroMpu6050::accepts(settings) &&
         (settings.gyro_period_ms == 0 || (drivers::Gyro::can_be() && !takes_bus_of_gyro()));
}

bool Sensors::takes_bus_of_gyro() const {
  return drivers::Gyro::needs_twi() && pins_.use_twi_pins();
}

void Sensors::configure(const protocol::ConfigurePins& settings) {
  gyro_.restart();  // The bus's pins are given back before they are given away.
  pins_.configure(settings);
  analog_.reset();
  if (takes_bus_of_gyro()) {
    settings_.gyro_period_ms = 0;
  }
}

void Sensors::configure(const protocol::ConfigureSensors& settings) {
  settings_ = settings;
  gyro_.restart();
}

void Sensors::tick() {
  hazards_.update(pins_.active_hazards());
  analog_.tick(pins_, scalar_);
  scalar_.tick();
  gyro_.tick(settings_);
}

}  // namespace tasks
}  // namespace echomap
