// SPDX-License-Identifier: MIT
#include "firmware/tasks/sensors.hpp"

#include "firmware/hal/code_size.hpp"
#include "firmware/hal/twi.hpp"

namespace echomap {
namespace tasks {

bool Sensors::accepts(const protocol::ConfigureSensors& settings) {
  return drivers::GyroMpu6050::accepts(settings) &&
         (settings.gyro_period_ms == 0 || hal::has_twi());
}

ECHOMAP_ONE_PIECE void Sensors::configure(const protocol::ConfigurePins& settings) {
  pins_.configure(settings);
  analog_.reset();
}

void Sensors::configure(const protocol::ConfigureSensors& settings) {
  settings_ = settings;
  gyro_.restart();
}

void Sensors::tick() {
  hazards_.update(pins_.active_hazards());
  analog_.tick(pins_);
  gyro_.tick(settings_);
}

}  // namespace tasks
}  // namespace echomap
