// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace boards {

/// Gives this start a boot id of its own; once, before hal::boot_id.
void number_this_boot();

}  // namespace boards
}  // namespace echomap
