// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::console {

/// Waits until the user presses Enter. False where there is nobody who could, as at the end of
/// stdin, or where the user has had enough (interrupted()).
bool wait_for_enter();

}  // namespace echomap::console
