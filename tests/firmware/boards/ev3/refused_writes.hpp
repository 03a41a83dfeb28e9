// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

#include <sys/resource.h>

namespace echomap::tests {

/// While it lives, the kernel refuses this process some writes into files, then takes them again.
class RefusedWrites {
 public:
  explicit RefusedWrites(int count) {
    remaining = count;
    ::getrlimit(RLIMIT_FSIZE, &usual);
    former_ = std::signal(SIGXFSZ, &RefusedWrites::on_refusal);
    set_limit(0);
  }
  ~RefusedWrites() {
    set_limit(usual.rlim_cur);
    std::signal(SIGXFSZ, former_);
  }
  RefusedWrites(const RefusedWrites&) = delete;
  RefusedWrites& operator=(const RefusedWrites&) = delete;

  /// How many have not come yet.
  static int left() { return remaining; }

 private:
  static void on_refusal(int /*signal*/) {
    remaining = remaining - 1;
    if (remaining == 0) {
      set_limit(usual.rlim_cur);
    }
  }
  static void set_limit(rlim_t bytes) {
    const rlimit limit{bytes, usual.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }

  inline static volatile std::sig_atomic_t remaining = 0;
  inline static rlimit usual{};
  void (*former_)(int) = nullptr;
};

}  // namespace echomap::tests
