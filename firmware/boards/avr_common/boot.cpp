// SPDX-License-Identifier: MIT
#include "firmware/boards/avr_common/boot.hpp"

#include <avr/eeprom.h>
#include <avr/io.h>
#include <avr/wdt.h>

#include "firmware/hal/boot.hpp"
#include "protocol/handshake_messages.hpp"

namespace echomap {
namespace boards {
namespace {

static_assert(_BV(PORF) == protocol::kResetPowerOn && _BV(EXTRF) == protocol::kResetExternal &&
                  _BV(BORF) == protocol::kResetBrownOut && _BV(WDRF) == protocol::kResetWatchdog,
              "MCUSR goes over the wire as it is");

/// None is cleared at the start: a reset leaves the RAM as it was, a power cut does not.
uint16_t boot_number __attribute__((section(".noinit")));
uint16_t boot_check __attribute__((section(".noinit")));
uint8_t first_mcusr __attribute__((section(".noinit")));
uint16_t hang_mark __attribute__((section(".noinit")));
constexpr uint16_t kHung = 0xD06E;

/// What a power cut forgets the EEPROM keeps; it is written at each power-up, which it endures
/// 100,000 times.
uint16_t power_up_number EEMEM;
constexpr uint16_t kResetsPerPowerUp = 256;

/// Runs before main, because a watchdog that has reset the chip is still running at its fastest.
/// A bootloader that clears MCUSR (Optiboot) hides the cause: it then reads 0, but for a watchdog
/// that could warn.
extern "C" void keep_reset_cause() __attribute__((naked, used, section(".init3")));
extern "C" void keep_reset_cause() {
  first_mcusr = MCUSR;
  MCUSR = 0;
  wdt_disable();
}

}  // namespace

void number_this_boot() {
  if (first_mcusr == 0 && hang_mark == kHung) {
    first_mcusr = protocol::kResetWatchdog;
  }
  hang_mark = 0;
  if (boot_check == static_cast<uint16_t>(~boot_number)) {
    ++boot_number;
  } else {
    boot_number = static_cast<uint16_t>(eeprom_read_word(&power_up_number) + kResetsPerPowerUp);
    eeprom_update_word(&power_up_number, boot_number);
  }
  boot_check = static_cast<uint16_t>(~boot_number);
}

void remember_hang() { hang_mark = kHung; }

}  // namespace boards

namespace hal {

uint8_t reset_cause() { return boards::first_mcusr; }

uint16_t boot_id() { return boards::boot_number; }

}  // namespace hal
}  // namespace echomap
