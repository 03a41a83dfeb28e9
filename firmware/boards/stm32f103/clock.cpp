// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/registers.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kCrystalHz = 72000000;
constexpr uint32_t kInternalHz = 8000000;

uint32_t running_hz = kInternalHz;

/// Waits until all of `bits` are set, 15 ms at most: a crystal starts in 2 ms or never.
bool wait_for(const Register& status, uint32_t bits) {
  for (uint32_t polls = 15000; polls != 0; --polls) {
    if ((status & bits) == bits) {
      return true;
    }
  }
  return false;
}

/// Crystal of 8 MHz times 9. Without it the board runs at 8 MHz, slower but on: half microseconds
/// and baud rates divide from both.
bool start_crystal() {
  rcc().cr |= kRccCrHseOn;
  if (!wait_for(rcc().cr, kRccCrHseReady)) {
    return false;
  }
  flash().acr = kFlashAcrPrefetch | kFlashAcrTwoWaitStates;
  rcc().cfgr = kRccCfgrPllTimes9 | kRccCfgrPllFromHse | kRccCfgrApb1Half | kRccCfgrAdcSixth;
  rcc().cr |= kRccCrPllOn;
  if (!wait_for(rcc().cr, kRccCrPllReady)) {
    return false;
  }
  rcc().cfgr |= kRccCfgrSwPll;
  return wait_for(rcc().cfgr, kRccCfgrSwsPll);
}

}  // namespace

void start_clock() {
  running_hz = start_crystal() ? kCrystalHz : kInternalHz;
  rcc().apb2enr =
      kRccApb2Afio | kRccApb2PortA | kRccApb2PortB | kRccApb2Adc1 | kRccApb2Tim1 | kRccApb2Usart1;
  rcc().apb1enr = kRccApb1Tim2 | kRccApb1Tim3 | kRccApb1Tim4 | kRccApb1Wwdg | kRccApb1I2c2;
  afio().mapr = kAfioMaprSwdOnly | kAfioMaprTim2OnPa15Pb3;
}

uint32_t clock_hz() { return running_hz; }

bool runs_by_crystal() { return running_hz == kCrystalHz; }

uint32_t half_us_prescaler() { return running_hz / 2000000 - 1; }

}  // namespace boards
}  // namespace echomap
