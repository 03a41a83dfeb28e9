// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/wait.h>

namespace echomap::tests {

/// How another program keeps others off a port.
enum class PortKeeping {
  kFlock,     ///< As picocom and echomap do it; of root as well.
  kTiocexcl,  ///< As arduino-cli does it.
  kNotAtAll,  ///< As avrdude, which only has it open.
};

/// Another process that has a port while this exists, and then is killed.
class PortKeeper {
 public:
  PortKeeper(const std::string& port, PortKeeping keeping) {
    int ready[2] = {-1, -1};
    if (::pipe2(ready, O_CLOEXEC) != 0 || (pid_ = ::fork()) < 0) {
      throw std::runtime_error("no process to keep a port");
    }
    if (pid_ == 0) {
      keep(port, keeping, ready[1]);
    }
    ::close(ready[1]);
    char byte = 0;
    const bool has_it = ::read(ready[0], &byte, 1) == 1;
    ::close(ready[0]);
    if (!has_it) {
      end();
      throw std::runtime_error("another process cannot have " + port);
    }
  }
  ~PortKeeper() { end(); }
  PortKeeper(const PortKeeper&) = delete;
  PortKeeper& operator=(const PortKeeper&) = delete;

  int pid() const { return pid_; }

 private:
  /// Of the child, which has this program's memory and must not end as it does.
  [[noreturn]] static void keep(const std::string& port, PortKeeping keeping, int ready) {
    // Not what the child was given of this program: other ports, which would count as kept, too.
    ::close_range(3, static_cast<unsigned>(ready) - 1, 0);
    ::close_range(static_cast<unsigned>(ready) + 1, ~0U, 0);
    const int fd = ::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    const bool has_it = fd >= 0 &&
                        (keeping != PortKeeping::kFlock || ::flock(fd, LOCK_EX | LOCK_NB) == 0) &&
                        (keeping != PortKeeping::kTiocexcl || ::ioctl(fd, TIOCEXCL) == 0);
    if (has_it && ::write(ready, "y", 1) == 1) {
      ::pause();
    }
    ::_exit(1);
  }
  void end() const {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }

  pid_t pid_ = -1;
};

}  // namespace echomap::tests
