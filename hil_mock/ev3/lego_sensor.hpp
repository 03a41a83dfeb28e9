// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hil_mock/ev3/sysfs_file.hpp"

namespace echomap::ev3 {

/// What a sensor's folder tells of it when it is plugged in.
struct LegoSensorKind {
  std::string driver_name;
  std::string mode;  ///< The first one.
  int decimals = 0;
};

/// A folder of /sys/class/lego-sensor.
class LegoSensor {
 public:
  /// `address` is that of the port: "ev3-ports:in1".
  LegoSensor(const std::filesystem::path& folder,
             const std::string& address,
             const LegoSensorKind& kind);

  /// The mode that the program has chosen.
  std::string mode() const { return mode_.text(); }
  void show(long value) { value0_.show(value); }

 private:
  SysfsFile mode_;
  SysfsFile value0_;
};

}  // namespace echomap::ev3
