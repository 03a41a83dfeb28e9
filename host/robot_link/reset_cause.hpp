// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace echomap::robot_link {

/// A set of protocol::ResetCause bits in words, as in "brown-out, watchdog".
std::string reset_cause_text(std::uint8_t reset_cause);

}  // namespace echomap::robot_link
