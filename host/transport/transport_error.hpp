// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace echomap::transport {

/// A stream could not be opened: what failed, why, and what to run next. `what()` holds all three.
class TransportError : public std::runtime_error {
 public:
  TransportError(const std::string& failure, const std::string& why, const std::string& next_step)
      : std::runtime_error(failure + ": " + why + "\n  next: " + next_step),
        failure_(failure),
        why_(why),
        next_step_(next_step) {}

  const std::string& failure() const { return failure_; }
  const std::string& why() const { return why_; }
  const std::string& next_step() const { return next_step_; }

 private:
  std::string failure_;
  std::string why_;
  std::string next_step_;
};

}  // namespace echomap::transport
