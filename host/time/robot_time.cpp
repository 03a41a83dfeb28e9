// SPDX-License-Identifier: MIT
#include "host/time/robot_time.hpp"

#include <algorithm>

namespace echomap::time {

RobotTime RobotTimeUnwrapper::unwrap(std::uint32_t stamp_us) {
  if (started_) {
    const auto last_stamp_us = static_cast<std::uint32_t>(last_us_ - epoch_us_);
    last_us_ += static_cast<std::int32_t>(stamp_us - last_stamp_us);
  } else {
    epoch_us_ += std::max<std::int64_t>(0, passed_us_ - stamp_us);
    last_us_ = epoch_us_ + stamp_us;
  }
  started_ = true;
  return RobotTime(RobotClock::duration(last_us_));
}

void RobotTimeUnwrapper::restart(RobotClock::duration passed) {
  epoch_us_ = last_us_;
  passed_us_ = passed.count();
  started_ = false;
}

}  // namespace echomap::time
