// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pacer.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace echomap::runner {
namespace {

constexpr double kForgivenLagS = 0.5;

}  // namespace

Pacer::Pacer(double speed, Moment begin) : speed_(speed), begin_(begin) {
  if (!(speed > 0.0)) {
    throw std::invalid_argument("the speed must be positive");
  }
}

std::int64_t Pacer::due_ns(Moment now, std::int64_t reached_ns) {
  if (std::isinf(speed_)) {
    return std::numeric_limits<std::int64_t>::max();
  }
  const double passed_s = std::chrono::duration<double>(now - begin_).count();
  const std::int64_t due_ns = begin_ns_ + std::llround(passed_s * speed_ * 1e9);
  if (static_cast<double>(due_ns - reached_ns) <= kForgivenLagS * speed_ * 1e9) {
    return due_ns;
  }
  begin_ = now;
  begin_ns_ = reached_ns;
  return reached_ns;
}

}  // namespace echomap::runner
