// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace echomap::bench {

/// Processor time of a piece of work on this thread, seconds: what others do on the machine counts
/// less than on a wall clock.
template <typename Work>
double processor_seconds(Work&& work) {
  const auto now_s = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start_s = now_s();
  work();
  return now_s() - start_s;
}

}  // namespace echomap::bench
