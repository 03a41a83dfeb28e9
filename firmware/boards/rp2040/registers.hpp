// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/rp2040/register.hpp"

/// The registers of the RP2040 that the firmware uses, but those of its USB controller. Source:
/// RP2040 data sheet, the section named at each block; ARMv6-M Architecture Reference Manual for
/// the core.
namespace echomap {
namespace boards {
/// Apart from those of other chips, which have the same names.
inline namespace rp2040 {

/// Clocks, 2.15: each has a choice of source, a divider and a read-back of the choice.
struct ClockRegisters {
  Register ctrl, div, selected;
};
struct ClocksRegisters {
  ClockRegisters gpout[4], ref, sys, peri, usb, adc, rtc;
};
inline ClocksRegisters& clocks() { return block_at<ClocksRegisters>(0x40008000); }
constexpr uint32_t kClockEnable = bit(11);
constexpr uint32_t kClockRefFromCrystal = 2;
constexpr uint32_t kClockSysFromRef = 0;
constexpr uint32_t kClockSysFromPll = 1;

/// Crystal oscillator, 2.16.
struct CrystalRegisters {
  Register ctrl, status, dormant, startup;
};
inline CrystalRegisters& crystal() { return block_at<CrystalRegisters>(0x40024000); }
constexpr uint32_t kCrystalEnable = 0xFABAA0;
constexpr uint32_t kCrystalStable = bit(31);

/// Phase-locked loops, 2.18.
struct PllRegisters {
  Register cs, pwr, fbdiv, prim;
};
inline PllRegisters& pll_sys() { return block_at<PllRegisters>(0x40028000); }
inline PllRegisters& pll_usb() { return block_at<PllRegisters>(0x4002C000); }
constexpr uint32_t kPllLocked = bit(31);
constexpr uint32_t kPllCoreOff = bit(0);
constexpr uint32_t kPllPostDividersOff = bit(3);
constexpr uint32_t kPllOscillatorOff = bit(5);

/// Ring oscillator, 2.17: only its random bit.
struct RingOscillatorRegisters {
  Register ctrl, freqa, freqb, dormant, div, phase, status, randombit;
};
inline RingOscillatorRegisters& ring_oscillator() {
  return block_at<RingOscillatorRegisters>(0x40060000);
}

/// Resets of the peripherals, 2.14.
struct ResetsRegisters {
  Register reset, wdsel, done;
};
inline ResetsRegisters& resets() { return block_at<ResetsRegisters>(0x4000C000); }
constexpr uint32_t kResetAdc = bit(0);
constexpr uint32_t kResetI2c0 = bit(3);
constexpr uint32_t kResetIoBank0 = bit(5);
constexpr uint32_t kResetPadsBank0 = bit(8);
constexpr uint32_t kResetPio0 = bit(10);
constexpr uint32_t kResetPllSys = bit(12);
constexpr uint32_t kResetPllUsb = bit(13);
constexpr uint32_t kResetPwm = bit(14);
constexpr uint32_t kResetTimer = bit(21);
constexpr uint32_t kResetUart0 = bit(22);
constexpr uint32_t kResetUsb = bit(24);

/// Power-on state machine, 2.13: what the watchdog resets.
struct PowerRegisters {
  Register frce_on, frce_off, wdsel, done;
};
inline PowerRegisters& power() { return block_at<PowerRegisters>(0x40010000); }
constexpr uint32_t kPowerAllButOscillators = 0x1FFFC;

/// Cause of a reset of the whole chip, 2.10.
struct ChipResetRegisters {
  Register vreg, bod, chip_reset;
};
inline ChipResetRegisters& chip_reset() { return block_at<ChipResetRegisters>(0x40064000); }
constexpr uint32_t kChipResetPowerOn = bit(8);
constexpr uint32_t kChipResetRunPin = bit(16);

/// Watchdog, 4.7.
struct WatchdogRegisters {
  Register ctrl, load, reason, scratch[8], tick;
};
inline WatchdogRegisters& watchdog() { return block_at<WatchdogRegisters>(0x40058000); }
constexpr uint32_t kWatchdogEnable = bit(30);
constexpr uint32_t kWatchdogTrigger = bit(31);
constexpr uint32_t kWatchdogTickEnable = bit(9);

/// Timer, 4.6: microseconds, and four alarms.
struct TimerRegisters {
  Register timehw, timelw, timehr, timelr, alarm[4], armed, timerawh, timerawl, dbgpause, pause,
      intr, inte, intf, ints;
};
inline TimerRegisters& timer() { return block_at<TimerRegisters>(0x40054000); }

/// What the pins do, 2.19.6: a word of functions for each, and four interrupt bits.
struct PinFunctionRegisters {
  Register status, ctrl;
};
struct PinsRegisters {
  PinFunctionRegisters pin[30];
  Register intr[4], inte[4], intf[4], ints[4];
};
inline PinsRegisters& pins() { return block_at<PinsRegisters>(0x40014000); }

/// Pads, 2.19.6.3.
struct PadsRegisters {
  Register voltage, pin[30];
};
inline PadsRegisters& pads() { return block_at<PadsRegisters>(0x4001C000); }
constexpr uint32_t kPadSchmitt = bit(1);
constexpr uint32_t kPadPullDown = bit(2);
constexpr uint32_t kPadPullUp = bit(3);
constexpr uint32_t kPad4Ma = bit(4);
constexpr uint32_t kPadInput = bit(6);
constexpr uint32_t kPadNoOutput = bit(7);

/// Levels of the pins, 2.3.1.7.
struct SioRegisters {
  Register cpuid, in, hi_in, reserved, out, out_set, out_clr, out_xor, oe, oe_set, oe_clr;
};
inline SioRegisters& sio() { return block_at<SioRegisters>(0xD0000000); }

/// UART, 4.2: a PL011.
struct UartRegisters {
  Register dr, rsr, reserved_8[4], fr, reserved_1c, ilpr, ibrd, fbrd, lcr_h, cr, ifls, imsc, ris,
      mis, icr;
};
inline UartRegisters& uart0() { return block_at<UartRegisters>(0x40034000); }
constexpr uint32_t kUartDrOverrun = bit(11);
constexpr uint32_t kUartDrDamaged = bit(8) | bit(9) | bit(10);
constexpr uint32_t kUartFrReceiveEmpty = bit(4);
constexpr uint32_t kUartFrSendFull = bit(5);
constexpr uint32_t kUartLcrFifos = bit(4);
constexpr uint32_t kUartLcr8Bits = 3U << 5;
constexpr uint32_t kUartCrEnable = bit(0);
constexpr uint32_t kUartCrSender = bit(8);
constexpr uint32_t kUartCrReceiver = bit(9);
constexpr uint32_t kUartReceived = bit(4);
constexpr uint32_t kUartSendLow = bit(5);
constexpr uint32_t kUartReceiveTimeout = bit(6);

/// I2C, 4.3: a DW_apb_i2c.
struct I2cRegisters {
  Register con, tar, sar, reserved_0c, data_cmd, ss_scl_hcnt, ss_scl_lcnt, fs_scl_hcnt, fs_scl_lcnt,
      reserved_24[2], intr_stat, intr_mask, raw_intr_stat, rx_tl, tx_tl, clr_intr, clr_rx_under,
      clr_rx_over, clr_tx_over, clr_rd_req, clr_tx_abrt, clr_rx_done, clr_activity, clr_stop_det,
      clr_start_det, clr_gen_call, enable, status, txflr, rxflr, sda_hold, reserved_80[8],
      fs_spklen;
};
inline I2cRegisters& i2c0() { return block_at<I2cRegisters>(0x40044000); }
constexpr uint32_t kI2cConMaster = bit(0);
constexpr uint32_t kI2cConFast = 2U << 1;
constexpr uint32_t kI2cConRestart = bit(5);
constexpr uint32_t kI2cConNoSlave = bit(6);
constexpr uint32_t kI2cRead = bit(8);
constexpr uint32_t kI2cStop = bit(9);
constexpr uint32_t kI2cRestart = bit(10);
constexpr uint32_t kI2cAborted = bit(6);
constexpr uint32_t kI2cStopped = bit(9);

/// ADC, 4.9.
struct AdcRegisters {
  Register cs, result;
};
inline AdcRegisters& adc() { return block_at<AdcRegisters>(0x4004C000); }
constexpr uint32_t kAdcEnable = bit(0);
constexpr uint32_t kAdcStart = bit(2);
constexpr uint32_t kAdcReady = bit(8);
constexpr uint8_t kAdcChannelShift = 12;

/// PWM, 4.5.
struct SliceRegisters {
  Register csr, div, ctr, cc, top;
};
struct PwmRegisters {
  SliceRegisters slice[8];
};
inline PwmRegisters& pwm() { return block_at<PwmRegisters>(0x40050000); }
constexpr uint32_t kPwmEnable = bit(0);
constexpr uint32_t kPwmInvertA = bit(2);
constexpr uint32_t kPwmGatedByB = 1U << 4;

/// PIO, 3.7.
struct StateMachineRegisters {
  Register clkdiv, execctrl, shiftctrl, addr, instr, pinctrl;
};
struct PioRegisters {
  Register ctrl, fstat, fdebug, flevel, txf[4], rxf[4], irq, irq_force, input_sync_bypass,
      dbg_padout, dbg_padoe, dbg_cfginfo, instr_mem[32];
  StateMachineRegisters machine[4];
  Register intr, irq0_inte, irq0_intf, irq0_ints, irq1_inte, irq1_intf, irq1_ints;
};
inline PioRegisters& pio0() { return block_at<PioRegisters>(0x50200000); }
constexpr uint8_t kPioReceiveEmptyShift = 8;  ///< In FSTAT, by state machine.
constexpr uint8_t kPioFlagShift = 8;          ///< Of the IRQ flags in INTE.

/// NVIC of the core, B3.4: priorities are four to a word.
struct NvicRegisters {
  Register iser[32], icer[32], ispr[32], icpr[32], reserved[64], ipr[8];
};
inline NvicRegisters& nvic() { return block_at<NvicRegisters>(0xE000E100); }

/// SCB of the core, B3.2: only where the vectors are.
struct ScbRegisters {
  Register cpuid, icsr, vtor;
};
inline ScbRegisters& scb() { return block_at<ScbRegisters>(0xE000ED00); }

}  // namespace rp2040
}  // namespace boards
}  // namespace echomap
