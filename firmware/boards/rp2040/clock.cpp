// SPDX-License-Identifier: MIT
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/registers.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kCrystalMhz = 12;
constexpr uint32_t kPartsOfOurs = kResetAdc | kResetI2c0 | kResetIoBank0 | kResetPadsBank0 |
                                  kResetPio0 | kResetPwm | kResetTimer | kResetUart0 | kResetUsb;

/// Waits as long as it takes: without a crystal the chip has no clock that the robot could use, and
/// the motors are off.
void wait_for(const Register& status, uint32_t bits) {
  while ((status & bits) != bits) {
  }
}

void start_crystal() {
  constexpr uint32_t kStartOf1Ms = 47;  // Times 256 periods.
  crystal().startup = kStartOf1Ms;
  crystal().ctrl = kCrystalEnable;
  wait_for(crystal().status, kCrystalStable);
}

/// 12 MHz times `feedback`, divided by both post-dividers.
void start_pll(PllRegisters& pll, uint32_t feedback, uint32_t divider_1, uint32_t divider_2) {
  pll.cs = 1;
  pll.fbdiv = feedback;
  clear_bits(pll.pwr, kPllCoreOff | kPllOscillatorOff);
  wait_for(pll.cs, kPllLocked);
  pll.prim = divider_1 << 16 | divider_2 << 12;
  clear_bits(pll.pwr, kPllPostDividersOff);
}

/// The read-back of a choice has a bit for each source.
void choose(ClockRegisters& clock, uint32_t source) {
  clock.ctrl = source;
  wait_for(clock.selected, bit(static_cast<uint8_t>(source)));
}

}  // namespace

void reset_parts(uint32_t parts) {
  set_bits(resets().reset, parts);
  clear_bits(resets().reset, parts);
  wait_for(resets().done, parts);
}

void start_clock() {
  start_crystal();
  choose(clocks().sys, kClockSysFromRef);
  choose(clocks().ref, kClockRefFromCrystal);
  reset_parts(kResetPllSys | kResetPllUsb);
  start_pll(pll_sys(), 125, 6, 2);
  start_pll(pll_usb(), 100, 5, 5);
  choose(clocks().sys, kClockSysFromPll);
  clocks().peri.ctrl = kClockEnable;
  clocks().usb.ctrl = kClockEnable;
  clocks().adc.ctrl = kClockEnable;
  watchdog().tick = kWatchdogTickEnable | kCrystalMhz;
  reset_parts(kPartsOfOurs);
}

}  // namespace boards
}  // namespace echomap
