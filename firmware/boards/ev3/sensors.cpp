// SPDX-License-Identifier: MIT
#include <stdio.h>
#include <string.h>

#include "firmware/boards/ev3/parts.hpp"
#include "firmware/boards/ev3/sysfs.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/range_sensor.hpp"
#include "firmware/hal/yaw_gyro.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr size_t kNameBytes = 32;

/// What is known of a sensor that measures ranges. The ages are assumed, but for the NXT's, whose
/// driver asks it every 100 ms: a measurement may begin just before a ping, end 38 ms later without
/// an echo, and be followed by the first that counts.
struct RangeKind {
  const char* driver_name;
  const char* mode;
  uint8_t mm_per_unit;
  uint8_t greatest_age_ms;
  int16_t nothing;  ///< The least value that says so.
};

constexpr RangeKind kRangeKinds[] = {
    {"lego-ev3-us", "US-DIST-CM", 1, 100, 2550},
    {"lego-nxt-us", "US-DIST-CM", 10, 150, 255},
    {"lego-ev3-ir", "IR-PROX", 7, 100, 100},  // Percent of about 70 cm, more of bright things.
};

Attribute left_touch;
Attribute right_touch;
Attribute yaw;
Attribute range;
const RangeKind* range_kind = nullptr;

bool has_driver(const DeviceFolder& folder, const char* wanted) {
  Attribute driver_name;
  char name[kNameBytes];
  return driver_name.open(folder, "driver_name", Access::kRead) &&
         driver_name.read_word(name, sizeof name) && strcmp(name, wanted) == 0;
}

/// Written only where it is another: some sensors start again with each mode.
void set_mode(const DeviceFolder& folder, const char* port, const char* wanted) {
  Attribute mode;
  char name[kNameBytes];
  if (mode.open(folder, "mode", Access::kRead) && mode.read_word(name, sizeof name) &&
      strcmp(name, wanted) == 0) {
    return;
  }
  snprintf(name, sizeof name, "%s\n", wanted);
  if (!mode.open(folder, "mode", Access::kWrite) || !mode.write(name)) {
    fprintf(stderr,
            "echomap-ev3: the sensor at %s cannot be set to %s: is the user in the group ev3dev?\n",
            port,
            wanted);
  }
}

void open_touch(const char* sysfs, const char* port, Attribute& touch) {
  DeviceFolder folder;
  const bool found = find_device(sysfs, "lego-sensor", port, folder) &&
                     (has_driver(folder, "lego-ev3-touch") || has_driver(folder, "lego-nxt-touch"));
  if (!found || !touch.open(folder, "value0", Access::kRead)) {
    fprintf(stderr, "echomap-ev3: no touch sensor at %s\n", port);
  }
}

void open_gyro(const char* sysfs) {
  DeviceFolder folder;
  if (!find_device(sysfs, "lego-sensor", "in3", folder) || !has_driver(folder, "lego-ev3-gyro")) {
    fprintf(stderr, "echomap-ev3: no gyro at in3\n");
    return;
  }
  set_mode(folder, "in3", "GYRO-ANG");
  yaw.open(folder, "value0", Access::kRead);
}

void open_range(const char* sysfs) {
  DeviceFolder folder;
  if (find_device(sysfs, "lego-sensor", "in4", folder)) {
    for (const RangeKind& kind : kRangeKinds) {
      if (has_driver(folder, kind.driver_name)) {
        set_mode(folder, "in4", kind.mode);
        range.open(folder, "value0", Access::kRead);
        range_kind = &kind;
        return;
      }
    }
  }
  fprintf(stderr, "echomap-ev3: no sonar or infrared sensor at in4\n");
}

bool is_closed(const Attribute& touch) {
  int32_t value = 0;
  return touch.read(value) && value != 0;
}

}  // namespace

void open_sensors(const char* sysfs) {
  left_touch = right_touch = yaw = range = Attribute();
  open_touch(sysfs, "in1", left_touch);
  open_touch(sysfs, "in2", right_touch);
  open_gyro(sysfs);
  open_range(sysfs);
}

}  // namespace boards

namespace hal {

/// A single sensor is one across the front, and counts as both.
uint8_t closed_contacts() {
  using namespace boards;
  const bool left = is_closed(left_touch.is_open() ? left_touch : right_touch);
  const bool right = is_closed(right_touch.is_open() ? right_touch : left_touch);
  return contact_bits(left, right);
}

bool has_range_sensor() { return true; }

RangeReading read_range() {
  using namespace boards;
  int32_t value = 0;
  if (!range.read(value)) {
    return RangeReading{RangeReading::State::kAbsent, 0, 0};
  }
  const uint8_t age_ms = range_kind->greatest_age_ms;
  if (value < 0 || value >= range_kind->nothing) {
    return RangeReading{RangeReading::State::kNothing, 0, age_ms};
  }
  const uint16_t range_mm = static_cast<uint16_t>(value * range_kind->mm_per_unit);
  return RangeReading{RangeReading::State::kRange, range_mm, age_ms};
}

bool has_yaw_gyro() { return true; }

/// LEGO's gyro counts to the right, and stays where it is at the end of 16 bits.
bool read_yaw_deg(int16_t& degrees) {
  int32_t value = 0;
  const bool is_read = boards::yaw.read(value) && value < INT16_MAX && value > -INT16_MAX;
  degrees = static_cast<int16_t>(-value);
  return is_read;
}

}  // namespace hal
}  // namespace echomap
