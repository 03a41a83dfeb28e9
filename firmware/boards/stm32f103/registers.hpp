// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/cortex_common/register.hpp"

/// The registers of the STM32F103 that the firmware uses. Sources: ST RM0008 (reference manual),
/// the chapter named at each block, and ST PM0056 (Cortex-M3 programming manual) for the core.
namespace echomap {
namespace boards {

/// RCC, chapter 7: clocks and the cause of the reset.
struct RccRegisters {
  Register cr, cfgr, cir, apb2rstr, apb1rstr, ahbenr, apb2enr, apb1enr, bdcr, csr;
};
inline RccRegisters& rcc() { return block_at<RccRegisters>(0x40021000); }

/// Bits of RCC, by register.
constexpr uint32_t kRccCrHseOn = bit(16);
constexpr uint32_t kRccCrHseReady = bit(17);
constexpr uint32_t kRccCrPllOn = bit(24);
constexpr uint32_t kRccCrPllReady = bit(25);
constexpr uint32_t kRccCfgrSwPll = 2U << 0;
constexpr uint32_t kRccCfgrSwsPll = 2U << 2;
constexpr uint32_t kRccCfgrApb1Half = 4U << 8;
constexpr uint32_t kRccCfgrAdcSixth = 2U << 14;
constexpr uint32_t kRccCfgrPllFromHse = bit(16);
constexpr uint32_t kRccCfgrPllTimes9 = 7U << 18;
constexpr uint32_t kRccApb2Afio = bit(0);
constexpr uint32_t kRccApb2PortA = bit(2);
constexpr uint32_t kRccApb2PortB = bit(3);
constexpr uint32_t kRccApb2Adc1 = bit(9);
constexpr uint32_t kRccApb2Tim1 = bit(11);
constexpr uint32_t kRccApb2Usart1 = bit(14);
constexpr uint32_t kRccApb1Tim2 = bit(0);
constexpr uint32_t kRccApb1Tim3 = bit(1);
constexpr uint32_t kRccApb1Tim4 = bit(2);
constexpr uint32_t kRccApb1Wwdg = bit(11);
constexpr uint32_t kRccApb1I2c2 = bit(22);
constexpr uint32_t kRccCsrRemoveFlags = bit(24);
constexpr uint32_t kRccCsrPin = bit(26);
constexpr uint32_t kRccCsrPowerOn = bit(27);
constexpr uint32_t kRccCsrSoftware = bit(28);
constexpr uint32_t kRccCsrIwdg = bit(29);
constexpr uint32_t kRccCsrWwdg = bit(30);

/// FLASH, ST PM0075: wait states, and writing the flash by half-words.
struct FlashRegisters {
  Register acr, keyr, optkeyr, sr, cr, ar;
};
inline FlashRegisters& flash() { return block_at<FlashRegisters>(0x40022000); }

/// Bits of FLASH, and the two words that unlock it.
constexpr uint32_t kFlashAcrTwoWaitStates = 2;
constexpr uint32_t kFlashAcrPrefetch = bit(4);
constexpr uint32_t kFlashKey1 = 0x45670123;
constexpr uint32_t kFlashKey2 = 0xCDEF89AB;
constexpr uint32_t kFlashSrBusy = bit(0);
constexpr uint32_t kFlashCrProgram = bit(0);
constexpr uint32_t kFlashCrPageErase = bit(1);
constexpr uint32_t kFlashCrStart = bit(6);
constexpr uint32_t kFlashCrLock = bit(7);

/// GPIO, chapter 9.
struct GpioRegisters {
  Register crl, crh, idr, odr, bsrr, brr, lckr;
};

/// AFIO, chapter 9.4: which pins the timers have, and of which port the lines of EXTI are.
struct AfioRegisters {
  Register evcr, mapr, exticr[4];
};
inline AfioRegisters& afio() { return block_at<AfioRegisters>(0x40010000); }

/// Bits of AFIO: TIM2_CH1 and CH2 on A15 and B3, and JTAG off, so that these and B4 are free.
constexpr uint32_t kAfioMaprTim2OnPa15Pb3 = 1U << 8;
constexpr uint32_t kAfioMaprSwdOnly = 2U << 24;

/// EXTI, chapter 10.3: a line for each number of a pin.
struct ExtiRegisters {
  Register imr, emr, rtsr, ftsr, swier, pr;
};
inline ExtiRegisters& exti() { return block_at<ExtiRegisters>(0x40010400); }

/// TIM1 (chapter 14) and TIM2 .. TIM4 (chapter 15).
struct TimerRegisters {
  Register cr1, cr2, smcr, dier, sr, egr, ccmr1, ccmr2, ccer, cnt, psc, arr, rcr;
  Register ccr1, ccr2, ccr3, ccr4, bdtr, dcr, dmar;
};
inline TimerRegisters& tim1() { return block_at<TimerRegisters>(0x40012C00); }
inline TimerRegisters& tim2() { return block_at<TimerRegisters>(0x40000000); }
inline TimerRegisters& tim3() { return block_at<TimerRegisters>(0x40000400); }
inline TimerRegisters& tim4() { return block_at<TimerRegisters>(0x40000800); }

/// Bits of the timers, by register.
constexpr uint32_t kTimCr1Enable = bit(0);
constexpr uint32_t kTimUpdate = bit(0);    ///< In DIER, SR and EGR.
constexpr uint32_t kTimCompare1 = bit(1);  ///< In DIER and SR.
constexpr uint32_t kTimCompare2 = bit(2);
constexpr uint32_t kTimCcmr1Pwm1 = 6U << 4;
constexpr uint32_t kTimCcmr1Pwm2 = 6U << 12;
constexpr uint32_t kTimCcmr1Preload1 = bit(3);
constexpr uint32_t kTimCcmr1Preload2 = bit(11);
constexpr uint32_t kTimCcmr1Capture1FromTi1 = 1U << 0;
constexpr uint32_t kTimCcmr1Capture2FromTi1 = 2U << 8;
constexpr uint32_t kTimCcmr1Capture2FromTi2 = 1U << 8;
constexpr uint32_t kTimCcmr1Filter8Of8 = 9;  ///< ICxF: a clock of 72 MHz / 8, 8 samples.
constexpr uint32_t kTimCcmr2Pwm4 = 6U << 12;
constexpr uint32_t kTimCcmr2Preload4 = bit(11);
constexpr uint32_t kTimSmcrEncoderBothInputs = 3;
constexpr uint32_t kTimBdtrOutputsOn = bit(15);  ///< MOE, of TIM1 only.
constexpr uint32_t kTimCcerEnable1 = bit(0);
constexpr uint32_t kTimCcerEnable2 = bit(4);
constexpr uint32_t kTimCcerEnable4 = bit(12);
constexpr uint32_t kTimCcerFalling2 = bit(5);   ///< Of a capture.
constexpr uint32_t kTimCcerInverted1 = bit(1);  ///< Of an output.
constexpr uint32_t kTimCcerInverted2 = bit(5);

/// USART, chapter 27.
struct UsartRegisters {
  Register sr, dr, brr, cr1, cr2, cr3, gtpr;
};
inline UsartRegisters& usart1() { return block_at<UsartRegisters>(0x40013800); }

/// Bits of the USART, by register.
constexpr uint32_t kUsartSrOverrun = bit(3);
constexpr uint32_t kUsartSrReceived = bit(5);
constexpr uint32_t kUsartSrSendEmpty = bit(7);
constexpr uint32_t kUsartCr1Receiver = bit(2);
constexpr uint32_t kUsartCr1Sender = bit(3);
constexpr uint32_t kUsartCr1ReceivedInterrupt = bit(5);
constexpr uint32_t kUsartCr1SendEmptyInterrupt = bit(7);
constexpr uint32_t kUsartCr1Enable = bit(13);

/// I2C, chapter 26.
struct I2cRegisters {
  Register cr1, cr2, oar1, oar2, dr, sr1, sr2, ccr, trise;
};
inline I2cRegisters& i2c2() { return block_at<I2cRegisters>(0x40005800); }

/// Bits of the I2C units, by register.
constexpr uint32_t kI2cCr1Enable = bit(0);
constexpr uint32_t kI2cCr1Start = bit(8);
constexpr uint32_t kI2cCr1Stop = bit(9);
constexpr uint32_t kI2cCr1Acknowledge = bit(10);
constexpr uint32_t kI2cCr1SecondByte = bit(11);  ///< POS: ACK is of the byte after the next.
constexpr uint32_t kI2cCr1Reset = bit(15);
constexpr uint32_t kI2cCr2ErrorInterrupt = bit(8);
constexpr uint32_t kI2cCr2EventInterrupt = bit(9);
constexpr uint32_t kI2cSr1Started = bit(0);
constexpr uint32_t kI2cSr1Address = bit(1);
constexpr uint32_t kI2cSr1EndOfByte =
    bit(2);  ///< BTF: and the one before was not read, or none follows.
constexpr uint32_t kI2cCcrFast = bit(15);

/// ADC, chapter 11.
struct AdcRegisters {
  Register sr, cr1, cr2, smpr1, smpr2, jofr[4], htr, ltr, sqr1, sqr2, sqr3, jsqr, jdr[4], dr;
};
inline AdcRegisters& adc1() { return block_at<AdcRegisters>(0x40012400); }

/// Bits of the converter, by register.
constexpr uint32_t kAdcSrDone = bit(1);
constexpr uint32_t kAdcCr2On = bit(0);
constexpr uint32_t kAdcCr2Calibrate = bit(2);
constexpr uint32_t kAdcCr2StartBySoftware = 0xFU << 17;  ///< EXTSEL and EXTTRIG.
constexpr uint32_t kAdcCr2Start = bit(22);

/// IWDG, chapter 19.
struct IwdgRegisters {
  Register kr, pr, rlr, sr;
};
inline IwdgRegisters& iwdg() { return block_at<IwdgRegisters>(0x40003000); }

/// What KR takes.
constexpr uint32_t kIwdgKick = 0xAAAA;
constexpr uint32_t kIwdgUnlock = 0x5555;
constexpr uint32_t kIwdgStart = 0xCCCC;

/// WWDG, chapter 20.
struct WwdgRegisters {
  Register cr, cfr, sr;
};
inline WwdgRegisters& wwdg() { return block_at<WwdgRegisters>(0x40002C00); }

/// Bits of the window watchdog: a step of its count of 64 takes 4096 cycles of the slower bus, or
/// as many more as WDGTB says.
constexpr uint32_t kWwdgCrOn = bit(7);
constexpr uint32_t kWwdgCfrWarning = bit(9);
constexpr uint32_t kWwdgCfrNoWindow = 0x7F;
constexpr uint32_t kWwdgCfrSteps8192 = 1U << 7;
constexpr uint32_t kWwdgCfrSteps32768 = 3U << 7;

/// SysTick, PM0056 section 4.5.
struct SysTickRegisters {
  Register ctrl, load, val, calib;
};
inline SysTickRegisters& sys_tick() { return block_at<SysTickRegisters>(0xE000E010); }

/// Bits of CTRL.
constexpr uint32_t kSysTickEnable = bit(0);
constexpr uint32_t kSysTickInterrupt = bit(1);
constexpr uint32_t kSysTickCoreClock = bit(2);

/// NVIC, PM0056 section 4.3: from the first of ISER on.
struct NvicRegisters {
  Register iser[32], icer[32], ispr[32], icpr[32], iabr[64];
  volatile uint8_t ipr[240];
};
inline NvicRegisters& nvic() { return block_at<NvicRegisters>(0xE000E100); }

/// SCB, PM0056 section 4.4.
struct ScbRegisters {
  Register cpuid, icsr, vtor, aircr, scr, ccr;
  volatile uint8_t shpr[12];
};
inline ScbRegisters& scb() { return block_at<ScbRegisters>(0xE000ED00); }

/// A bit of ICSR, AIRCR's key with SYSRESETREQ, and where SHPR has the priority of SysTick.
constexpr uint32_t kScbIcsrTickPending = bit(26);
constexpr uint32_t kScbAircrResetRequest = 0x05FA0000 | bit(2);
constexpr uint8_t kScbShprTick = 11;

}  // namespace boards
}  // namespace echomap
