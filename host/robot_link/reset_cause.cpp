// SPDX-License-Identifier: MIT
#include "host/robot_link/reset_cause.hpp"

#include <utility>

#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {

std::string reset_cause_text(std::uint8_t reset_cause) {
  std::string text;
  for (const auto& [bit, words] : {std::pair(protocol::kResetBrownOut, "brown-out"),
                                   std::pair(protocol::kResetWatchdog, "watchdog"),
                                   std::pair(protocol::kResetExternal, "reset line"),
                                   std::pair(protocol::kResetPowerOn, "power-on")}) {
    if ((reset_cause & bit) != 0) {
      text += (text.empty() ? "" : ", ") + std::string(words);
    }
  }
  return text.empty() ? "cause not reported" : text;
}

}  // namespace echomap::robot_link
