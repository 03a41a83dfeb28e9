// SPDX-License-Identifier: MIT
#include "host/mqtt/backoff.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace echomap::mqtt {
namespace {

void validate_field(const char* field, double value, double min, double max) {
  if (value < min || value > max || std::isnan(value)) {
    std::ostringstream text;
    text << "back-off: " << field << " = " << value << " is outside " << min << " .. " << max;
    throw std::invalid_argument(text.str());
  }
}

}  // namespace

Backoff::Backoff(const BackoffParams& params, std::uint32_t seed)
    : params_(params), random_(seed), step_s_(params.first_s) {
  validate_field("first_s", params.first_s, 0.001, 3600.0);
  validate_field("max_s", params.max_s, params.first_s, 3600.0);
  validate_field("factor", params.factor, 1.0, 100.0);
  validate_field("jitter", params.jitter, 0.0, 1.0);
  validate_field("steady_s", params.steady_s, 0.0, 3600.0);
}

void Backoff::note_connected(Clock::time_point now) { connected_ = now; }

void Backoff::note_failed(Clock::time_point now) {
  if (now > connected_ && now - connected_ > std::chrono::duration<double>(params_.steady_s)) {
    step_s_ = params_.first_s;
  }
  connected_ = Clock::time_point::max();
  const double even = static_cast<double>(random_()) / 4294967296.0;
  const std::chrono::duration<double> wait(step_s_ * (1.0 - params_.jitter * even));
  wait_ = std::chrono::duration_cast<Clock::duration>(wait);
  next_ = now + wait_;
  step_s_ = std::min(params_.max_s, step_s_ * params_.factor);
}

}  // namespace echomap::mqtt
