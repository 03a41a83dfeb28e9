// SPDX-License-Identifier: MIT
#include "host/console/wait_for_enter.hpp"

#include "host/console/question.hpp"

namespace echomap::console {

bool wait_for_enter() { return read_line().has_value(); }

}  // namespace echomap::console
