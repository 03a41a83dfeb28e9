// SPDX-License-Identifier: MIT
#include "host/transport/port_lock.hpp"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <vector>

#include <sys/file.h>
#include <sys/ioctl.h>

#include "host/transport/file_descriptor.hpp"
#include "host/transport/port_holder.hpp"

namespace echomap::transport {
namespace {

[[noreturn]] void refuse_held(const std::string& path, const PortHolder& holder) {
  throw PortHeldError(
      "cannot open " + path, in_words(holder) + " holds it", remedy_against(holder, path));
}

/// By its name: half of all programs have /dev/null open.
bool is_serial_device(const std::string& device) {
  return device.starts_with("/dev/tty") || device.starts_with("/dev/rfcomm");
}

/// Where the device is locked, by whom is to be found out.
[[noreturn]] void refuse_locked(const std::string& path, const std::string& device) {
  if (const auto locker = flock_holder(device)) {
    if (locker->pid != ::getpid()) {
      refuse_held(path, *locker);
    }
    throw PortHeldError("cannot open " + path,
                        "this program has it open already",
                        "name each port once, under one name");
  }
  if (const auto holders = port_holders(device); !holders.empty()) {
    refuse_held(path, holders.back());  // An emulator at its own pty is older.
  }
  for (const char* usual : {"ModemManager", "brltty"}) {
    const auto process = is_serial_device(device) ? process_named(usual) : std::nullopt;
    if (process) {
      throw PortHeldError("cannot open " + path,
                          "a program holds it, probably " + in_words(*process),
                          remedy_against(*process, path));
    }
  }
  throw PortHeldError("cannot open " + path,
                      "a program whose descriptors you may not read holds it",
                      "sudo fuser -v " + path + " shows which");
}

std::string real_device(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(path, ignored).string();
}

bool is_exclusive(int fd) {
  int exclusive = 0;
  return ::ioctl(fd, TIOCGEXCL, &exclusive) == 0 && exclusive != 0;
}

}  // namespace

void refuse_if_held(const std::string& path) {
  const std::string device = real_device(path);
  if (const auto holder = lock_file_holder(device)) {
    refuse_held(path, *holder);
  }
  if (const auto holders = port_holders(device); !holders.empty()) {
    refuse_held(path, holders.front());
  }
}

int open_port_alone(const std::string& path) {
  const std::string device = real_device(path);
  if (is_serial_device(device)) {
    refuse_if_held(path);
  }
  FileDescriptor fd(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (fd.get() < 0) {
    if (errno == EBUSY) {
      refuse_locked(path, device);
    }
    return -1;
  }
  if (is_exclusive(fd.get()) || ::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) {
    refuse_locked(path, device);
  }
  return fd.release();
}

void exclude_others(int fd) { ::ioctl(fd, TIOCEXCL); }

void admit_others(int fd) { ::ioctl(fd, TIOCNXCL); }

}  // namespace echomap::transport
