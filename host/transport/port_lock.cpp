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

/// Where the holder is another user's, or this program itself.
[[noreturn]] void refuse_held(const std::string& path, const std::string& device) {
  const auto holders = port_holders(device);
  if (!holders.empty()) {
    refuse_held(path, holders.front());
  }
  throw PortHeldError("cannot open " + path,
                      "a program whose descriptors you may not read, or this one, holds it",
                      "sudo fuser -v " + path + " shows which");
}

bool is_pty_device(const std::string& device) { return device.starts_with("/dev/pts/"); }

bool is_exclusive(int fd) {
  int exclusive = 0;
  return ::ioctl(fd, TIOCGEXCL, &exclusive) == 0 && exclusive != 0;
}

}  // namespace

int open_port_alone(const std::string& path) {
  std::error_code ignored;
  const std::string device = std::filesystem::weakly_canonical(path, ignored).string();
  if (const auto holder = lock_file_holder(device)) {
    refuse_held(path, *holder);
  }
  if (!is_pty_device(device)) {
    if (const auto holders = port_holders(device); !holders.empty()) {
      refuse_held(path, holders.front());
    }
  }
  FileDescriptor fd(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (fd.get() < 0) {
    if (errno == EBUSY) {
      refuse_held(path, device);
    }
    return -1;
  }
  if (is_exclusive(fd.get()) || ::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) {
    refuse_held(path, device);
  }
  return fd.release();
}

void exclude_others(int fd) { ::ioctl(fd, TIOCEXCL); }

void admit_others(int fd) { ::ioctl(fd, TIOCNXCL); }

}  // namespace echomap::transport
