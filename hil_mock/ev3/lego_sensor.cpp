// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/lego_sensor.hpp"

namespace echomap::ev3 {
namespace {

std::filesystem::path made_folder(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

LegoSensor::LegoSensor(const std::filesystem::path& folder,
                       const std::string& address,
                       const LegoSensorKind& kind)
    : mode_(made_folder(folder) / "mode", kind.mode), value0_(folder / "value0", "0") {
  SysfsFile(folder / "address", address);
  SysfsFile(folder / "driver_name", kind.driver_name);
  SysfsFile(folder / "decimals", std::to_string(kind.decimals));
  SysfsFile(folder / "num_values", "1");
}

}  // namespace echomap::ev3
