// SPDX-License-Identifier: MIT
#include "hil_mock/runner/duty_log.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace echomap::runner {
namespace {

std::pair<bool, bool> driven_wheels(const MotorDuty& duty) {
  return {duty.left != 0.0, duty.right != 0.0};
}

/// Linux: of CLOCK_MONOTONIC, as other programs of this machine read it.
std::int64_t monotonic_us() {
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(since_boot).count();
}

}  // namespace

DutyLog::DutyLog(const std::filesystem::path& file) : lines_(file) {
  lines_ << "sim_us,monotonic_us,left_duty,right_duty" << std::endl;
  if (!lines_) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

void DutyLog::note(std::int64_t now_ns, const MotorDuty& duty) {
  const bool is_change = driven_wheels(duty) != driven_wheels(last_);
  last_ = duty;
  if (is_change) {
    // A wheel that is told to go backwards at no duty stands at -0.
    lines_ << now_ns / 1000 << ',' << monotonic_us() << ',' << duty.left + 0.0 << ','
           << duty.right + 0.0 << std::endl;
  }
}

}  // namespace echomap::runner
