// SPDX-License-Identifier: MIT
#include "firmware/hal/range_sensor.hpp"
#include "firmware/hal/yaw_gyro.hpp"

/// No sensor of this board measures by itself.
namespace echomap {
namespace hal {

bool has_range_sensor() { return false; }
RangeReading read_range() { return RangeReading{RangeReading::State::kAbsent, 0, 0}; }

bool has_yaw_gyro() { return false; }
bool read_yaw_deg(int16_t& /*degrees*/) { return false; }

}  // namespace hal
}  // namespace echomap
