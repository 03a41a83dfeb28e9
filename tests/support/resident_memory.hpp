// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <fstream>
#include <unistd.h>

namespace echomap::tests {

/// Memory that this program holds, MB. 0 under the address sanitizer, which keeps what was freed,
/// and looks for leaks by itself, and under the thread sanitizer, which has much of its own.
inline double resident_mb() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return 0.0;
#else
  std::ifstream statm("/proc/self/statm");
  std::uint64_t whole = 0;
  std::uint64_t resident = 0;
  statm >> whole >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
#endif
}

}  // namespace echomap::tests
