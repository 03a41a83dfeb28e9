// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace echomap::console {

/// What the shell sees; the same for every sub-command.
enum class ExitCode : int {
  kOk = 0,
  kRuntimeError = 1,
  kUsage = 2,
  kNoRobot = 3,  ///< No robot found, or more than one.
  kFirmwareMismatch = 4,
  kLinkLost = 5,
  kConfigInvalid = 6,
  kSafetyStop = 7,  ///< The board stopped for good: lifted, a wheel out of control.
  kUnfinished = 8,  ///< Ended, and not with all that was asked for.
  kRobotFault = 9,  ///< The robot is not as its profile says, and no map can come of it.
  kInterrupted = 130,
};

/// Ends a sub-command with this exit code; what() says what, why and the next command.
class CommandError : public std::runtime_error {
 public:
  CommandError(ExitCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace echomap::console
