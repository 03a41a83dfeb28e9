// SPDX-License-Identifier: MIT
#include "firmware/hal/boot.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/registers.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap {
namespace boards {
namespace {

/// None is cleared at the start: a reset leaves the RAM as it was, a power cut does not.
uint16_t boot_number __attribute__((section(".noinit")));
uint16_t boot_check __attribute__((section(".noinit")));

uint8_t cause = 0;

/// The boot program, too, starts an image through the watchdog, once it has written it: this word
/// says that the watchdog's reset was one of ours.
constexpr uint32_t kOurs = 0x6563686F;

uint8_t cause_of_reset() {
  if (watchdog().reason != 0) {
    return watchdog().scratch[0] == kOurs ? protocol::kResetWatchdog : protocol::kResetExternal;
  }
  if ((chip_reset().chip_reset & kChipResetPowerOn) != 0) {
    return protocol::kResetPowerOn;
  }
  return protocol::kResetExternal;
}

/// Of 256 samples of the ring oscillator, which runs apart from the crystal that takes them.
uint16_t random_number() {
  constexpr uint16_t kPolynomial = 0x1021;
  uint16_t number = 0xFFFF;
  for (uint16_t sample = 0; sample < 256; ++sample) {
    const bool carry = (number & 0x8000) != 0;
    number = static_cast<uint16_t>(number << 1 ^ (ring_oscillator().randombit & 1));
    if (carry) {
      number ^= kPolynomial;
    }
  }
  return number;
}

}  // namespace

void number_this_boot() {
  cause = cause_of_reset();
  watchdog().scratch[0] = kOurs;
  boot_number = boot_check == static_cast<uint16_t>(~boot_number)
                    ? static_cast<uint16_t>(boot_number + 1)
                    : random_number();
  boot_check = static_cast<uint16_t>(~boot_number);
}

}  // namespace boards

namespace hal {

uint8_t reset_cause() { return boards::cause; }

uint16_t boot_id() { return boards::boot_number; }

}  // namespace hal
}  // namespace echomap
