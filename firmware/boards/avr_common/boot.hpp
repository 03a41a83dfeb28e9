// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace boards {

/// Gives this start a boot id of its own, and finds out why it is; once, before hal::boot_id.
void number_this_boot();
/// The program hangs: the next start tells so where a bootloader hides the cause.
void remember_hang();

}  // namespace boards
}  // namespace echomap
