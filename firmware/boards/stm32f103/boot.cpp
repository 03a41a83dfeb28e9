// SPDX-License-Identifier: MIT
#include "firmware/hal/boot.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/registers.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap {
namespace boards {
namespace {

/// None is cleared at the start: a reset leaves the RAM as it was, a power cut does not.
uint16_t boot_number __attribute__((section(".noinit")));
uint16_t boot_check __attribute__((section(".noinit")));

uint8_t cause = 0;
constexpr uint8_t kBitsOfResets = 8;

/// Every cause pulls the reset pin too, so that one alone means the pin. A fault resets by
/// software, in the watchdog's stead.
uint8_t cause_of(uint32_t flags) {
  if ((flags & kRccCsrPowerOn) != 0) {
    return protocol::kResetPowerOn;
  }
  if ((flags & (kRccCsrIwdg | kRccCsrWwdg | kRccCsrSoftware)) != 0) {
    return protocol::kResetWatchdog;
  }
  if ((flags & kRccCsrPin) != 0) {
    return protocol::kResetExternal;
  }
  return 0;
}

}  // namespace

void number_this_boot() {
  cause = cause_of(rcc().csr);
  rcc().csr = kRccCsrRemoveFlags;
  if (boot_check == static_cast<uint16_t>(~boot_number)) {
    ++boot_number;
  } else {
    boot_number = static_cast<uint16_t>(count_power_up() << kBitsOfResets);
  }
  boot_check = static_cast<uint16_t>(~boot_number);
}

}  // namespace boards

namespace hal {

uint8_t reset_cause() { return boards::cause; }

uint16_t boot_id() { return boards::boot_number; }

}  // namespace hal
}  // namespace echomap
