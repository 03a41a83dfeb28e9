// SPDX-License-Identifier: MIT
#include "host/flashing/boot_drive.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "host/console/exit_code.hpp"

namespace echomap::flashing {
namespace {

namespace fs = std::filesystem;
using console::CommandError;
using console::ExitCode;

constexpr transport::UsbId kBootLoader{0x2e8a, 0x0003};
constexpr transport::UsbId kRunningProgram{0x2e8a, 0x000a};

constexpr auto kHoldBootsel =
    "unplug the Pico, hold its button BOOTSEL while plugging it in, let go, and flash again";

/// A path of /proc/mounts, where blanks are written as \040.
fs::path unescaped(const std::string& text) {
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_octal = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '7'; };
    if (text[i] == '\\' && i + 3 < text.size() && is_octal(i + 1) && is_octal(i + 2) &&
        is_octal(i + 3)) {
      path += static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 +
                                (text[i + 3] - '0'));
      i += 3;
    } else {
      path += text[i];
    }
  }
  return path;
}

bool is_here(const std::vector<transport::UsbDevice>& usb, transport::UsbId id) {
  return std::ranges::find(usb, id, &transport::UsbDevice::id) != usb.end();
}

[[noreturn]] void refuse_without_drive(const std::vector<transport::UsbDevice>& usb) {
  const std::string none = "no drive of a Pico (RPI-RP2) is mounted";
  if (is_here(usb, kBootLoader)) {
    throw CommandError(ExitCode::kNoRobot,
                       none +
                           ", but a Pico in its boot loader is plugged in\n  next: open the drive "
                           "RPI-RP2 in the file manager, or: udisksctl mount -b "
                           "/dev/disk/by-label/RPI-RP2; then flash again");
  }
  if (is_here(usb, kRunningProgram)) {
    throw CommandError(
        ExitCode::kNoRobot,
        none + "; a Pico is plugged in that runs its program\n  next: " + kHoldBootsel);
  }
  throw CommandError(ExitCode::kNoRobot, none + "\n  next: " + kHoldBootsel);
}

/// Of a file that is being written to a drive; closed at the end whatever happens.
class DriveFile {
 public:
  explicit DriveFile(const fs::path& path)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {}
  ~DriveFile() {
    if (descriptor_ >= 0) {
      ::close(descriptor_);
    }
  }
  DriveFile(const DriveFile&) = delete;
  DriveFile& operator=(const DriveFile&) = delete;

  bool is_open() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

  /// Whether all bytes were taken; errno says why not.
  bool write(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t taken = ::write(descriptor_, bytes.data(), bytes.size());
      if (taken < 0 && errno == EINTR) {
        continue;
      }
      if (taken <= 0) {
        return false;
      }
      bytes = bytes.subspan(static_cast<std::size_t>(taken));
    }
    return true;
  }

 private:
  int descriptor_;
};

[[noreturn]] void refuse_to_write(const fs::path& path, int error) {
  throw CommandError(
      ExitCode::kRuntimeError,
      fmt::format("cannot write {}: {}\n  next: {}",
                  path.string(),
                  std::generic_category().message(error),
                  error == EACCES || error == EROFS ? "mount the drive so that you may write to it"
                                                    : kHoldBootsel));
}

/// How long a kernel still shows the files of a drive that is gone, at most.
constexpr std::chrono::milliseconds kTeardown(2000);

bool is_of_a_lost_device(int error) { return error == EIO || error == ENODEV || error == ENXIO; }

/// Whether the drive is gone, now or within `limit`.
bool goes_away(const fs::path& drive, std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (is_boot_drive(drive)) {
    if (std::chrono::steady_clock::now() >= end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

}  // namespace

bool is_boot_drive(const fs::path& folder) {
  std::ifstream file(folder / "INFO_UF2.TXT");
  std::string line;
  while (std::getline(file, line)) {
    if (line.find("RPI-RP2") != std::string::npos) {
      return true;
    }
  }
  return false;
}

std::vector<fs::path> mounted_boot_drives(const fs::path& mounts) {
  std::ifstream file(mounts);
  std::vector<fs::path> drives;
  std::set<std::string> devices;  // One may be mounted at several folders.
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string device;
    std::string folder;
    std::string kind;
    if (words >> device >> folder >> kind && kind == "vfat" && is_boot_drive(unescaped(folder)) &&
        devices.insert(device).second) {
      drives.push_back(unescaped(folder));
    }
  }
  return drives;
}

fs::path choose_boot_drive(const fs::path& named,
                           const std::vector<fs::path>& mounted,
                           const std::vector<transport::UsbDevice>& usb) {
  if (!named.empty()) {
    if (!is_boot_drive(named)) {
      throw CommandError(ExitCode::kNoRobot,
                         fmt::format("{} is no drive of a Pico: no INFO_UF2.TXT in it says "
                                     "RPI-RP2\n  next: {}",
                                     named.string(),
                                     kHoldBootsel));
    }
    return named;
  }
  if (mounted.empty()) {
    refuse_without_drive(usb);
  }
  if (mounted.size() > 1) {
    std::string text = "several Picos wait for a program\n";
    for (const fs::path& drive : mounted) {
      text += "  here: " + drive.string() + "\n";
    }
    throw CommandError(ExitCode::kNoRobot, text + "  next: name one of these drives with --volume");
  }
  return mounted.front();
}

void copy_to_boot_drive(std::span<const std::uint8_t> uf2,
                        const fs::path& drive,
                        const std::string& name,
                        const SyncFile& sync) {
  const fs::path path = drive / name;
  const DriveFile file(path);
  if (!file.is_open() || !file.write(uf2)) {
    refuse_to_write(path, errno);
  }
  if (sync(file.descriptor()) != 0) {
    const int error = errno;
    if (!goes_away(drive, is_of_a_lost_device(error) ? kTeardown : std::chrono::milliseconds(0))) {
      refuse_to_write(path, error);
    }
  }
}

}  // namespace echomap::flashing
