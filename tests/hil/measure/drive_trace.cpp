// SPDX-License-Identifier: MIT
#include "tests/hil/measure/drive_trace.hpp"

#include <algorithm>
#include <utility>

namespace echomap::tests {

DriveTrace::DriveTrace(runner::SimulatedBoard& board, world::MotorDriver driver)
    : board_(board), driver_(driver) {
  board_.on_duty = [this] { note(); };
  note();
}

std::int64_t DriveTrace::take_longest_ns() {
  note();
  for (std::int64_t& since_ns : since_ns_) {
    if (since_ns != kNotDriven) {
      longest_ns_ = std::max(longest_ns_, board_.now_ns() - since_ns);
      since_ns = board_.now_ns();
    }
  }
  return std::exchange(longest_ns_, 0);
}

void DriveTrace::note() {
  const runner::MotorDuty duty = board_.motor_duty(driver_);
  const std::array<bool, 2> driven{duty.left != 0.0, duty.right != 0.0};
  for (std::size_t i = 0; i < driven.size(); ++i) {
    std::int64_t& since_ns = since_ns_.at(i);
    if (driven.at(i) && since_ns == kNotDriven) {
      since_ns = board_.now_ns();
    } else if (!driven.at(i) && since_ns != kNotDriven) {
      longest_ns_ = std::max(longest_ns_, board_.now_ns() - since_ns);
      since_ns = kNotDriven;
    }
  }
}

}  // namespace echomap::tests
