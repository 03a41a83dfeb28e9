// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "host/transport/usb_id.hpp"

namespace echomap::tests {

/// A folder like /sys with the USB serial ports that are plugged in.
class SysfsTree {
 public:
  struct Device {
    std::string socket;  ///< "1-1.2".
    transport::UsbId id;
    std::string product;
    std::string serial_number = "";
  };

  explicit SysfsTree(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }

  /// `tty` as in "ttyUSB0".
  void plug(const std::string& tty, const Device& device) {
    namespace fs = std::filesystem;
    const fs::path usb = root_ / "devices" / "usb1" / device.socket;
    const fs::path port = usb / (device.socket + ":1.0") / tty;
    fs::create_directories(port);
    const std::string id = to_string(device.id);
    std::ofstream(usb / "idVendor") << id.substr(0, 4) << '\n';
    std::ofstream(usb / "idProduct") << id.substr(5) << '\n';
    std::ofstream(usb / "product") << device.product << '\n';
    if (!device.serial_number.empty()) {
      std::ofstream(usb / "serial") << device.serial_number << '\n';
    }
    const fs::path tty_folder = root_ / "class" / "tty" / tty;
    fs::create_directories(tty_folder);
    fs::create_symlink(port, tty_folder / "device");
  }

  void unplug(const std::string& tty) {
    namespace fs = std::filesystem;
    const fs::path tty_folder = root_ / "class" / "tty" / tty;
    fs::remove_all(fs::canonical(tty_folder / "device").parent_path().parent_path());
    fs::remove_all(tty_folder);
  }

 private:
  std::filesystem::path root_;
};

}  // namespace echomap::tests
