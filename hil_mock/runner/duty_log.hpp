// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::runner {

/// Writes when a wheel begins to be driven and when it comes to be driven no more, for those who
/// measure how fast a robot stops: simulated time, the machine's CLOCK_MONOTONIC and both duties,
/// as CSV, each line on disk at once.
class DutyLog {
 public:
  /// Begins the file anew. Throws std::runtime_error where it cannot be written.
  explicit DutyLog(const std::filesystem::path& file);

  /// Takes note of what the motors get now; both stood before the first call.
  void note(std::int64_t now_ns, const MotorDuty& duty);

 private:
  std::ofstream lines_;
  MotorDuty last_;
};

}  // namespace echomap::runner
