// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.hpp"

namespace echomap::tests {

/// Files in the place of a brick's sysfs. Nothing obeys them.
class BrickFolder {
 public:
  BrickFolder() {
    std::filesystem::create_directories(sysfs() / "class/tacho-motor");
    std::filesystem::create_directories(sysfs() / "class/lego-sensor");
  }

  std::filesystem::path sysfs() const { return folder_.path(); }

  /// Plugs in a motor; its folder.
  std::filesystem::path add_motor(int number, const std::string& address) {
    const auto folder = sysfs() / "class/tacho-motor" / ("motor" + std::to_string(number));
    std::filesystem::create_directories(folder);
    write(folder / "address", address);
    for (const char* const name : {"duty_cycle_sp", "position", "position_sp", "speed_sp"}) {
      write(folder / name, "0");
    }
    write(folder / "command", "");
    write(folder / "stop_action", "coast");
    return folder;
  }

  /// Plugs in a sensor; its folder.
  std::filesystem::path add_sensor(int number,
                                   const std::string& address,
                                   const std::string& driver_name,
                                   const std::string& mode) {
    const auto folder = sysfs() / "class/lego-sensor" / ("sensor" + std::to_string(number));
    std::filesystem::create_directories(folder);
    write(folder / "address", address);
    write(folder / "driver_name", driver_name);
    write(folder / "mode", mode);
    write(folder / "value0", "0");
    return folder;
  }

  static void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text << '\n';
  }

  /// The first line.
  static std::string read(const std::filesystem::path& file) {
    std::string line;
    std::getline(std::ifstream(file) >> std::ws, line);
    return line;
  }

 private:
  ScratchFolder folder_;
};

}  // namespace echomap::tests
