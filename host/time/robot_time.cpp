// SPDX-License-Identifier: MIT
#include "host/time/robot_time.hpp"

namespace echomap::time {

RobotTime RobotTimeUnwrapper::unwrap(std::uint32_t stamp_us) {
  const std::int64_t raw_us = last_us_ - epoch_us_;
  const auto step_us = static_cast<std::int32_t>(stamp_us - static_cast<std::uint32_t>(raw_us));
  last_us_ += step_us;
  return RobotTime(RobotClock::duration(last_us_));
}

void RobotTimeUnwrapper::restart() { epoch_us_ = last_us_; }

}  // namespace echomap::time
