// SPDX-License-Identifier: MIT
#include "host/time/robot_time.hpp"

namespace echomap::time {

RobotTime RobotTimeUnwrapper::unwrap(std::uint32_t stamp_us) {
  if (started_) {
    const auto last_stamp_us = static_cast<std::uint32_t>(last_us_ - epoch_us_);
    last_us_ += static_cast<std::int32_t>(stamp_us - last_stamp_us);
  } else {
    last_us_ = epoch_us_ + stamp_us;
  }
  started_ = true;
  return RobotTime(RobotClock::duration(last_us_));
}

void RobotTimeUnwrapper::restart() {
  epoch_us_ = last_us_;
  started_ = false;
}

}  // namespace echomap::time
