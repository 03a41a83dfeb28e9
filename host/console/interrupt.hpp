// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::console {

/// From now on Ctrl-C and SIGTERM only raise a flag, so that files are finished; a second one ends
/// the program at once.
void catch_interrupts();
bool interrupted();

}  // namespace echomap::console
