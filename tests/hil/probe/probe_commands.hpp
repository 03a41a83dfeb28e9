// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// Commands of the probe program; after a reset it first sends MCUSR and the byte that survived in
/// .noinit.
enum ProbeCommand : uint8_t {
  kProbeSendBurst = 1,    ///< Answers 0 .. 99 without a pause.
  kProbeOverrunReceiver,  ///< Is deaf for 20 ms; answers bytes then readable, DOR0.
  kProbeClearOneFlag,     ///< Answers TIFR0 with three flags, after clearing one, after the rest.
  kProbeEnableAfterFlag,  ///< Answers interrupts seen from a flag older than its enabling.
  kProbeTimeInterruptEntry,   ///< Answers TCNT1 (16 bit) in the handler of a match at 1000.
  kProbeWritePortWithPullUp,  ///< Writes PORTx, DDRx of the encoders; answers left A, its changes.
  kProbeWaitForWatchdog,      ///< Is reset after 15 ms; writes 77 into .noinit before.
  kProbeSleep100Ticks,        ///< Sleeps through 100 ticks of 1 ms, answers 'z'.
  kProbeCaptureEcho,    ///< Answers 'c', then counts of 0.5 us between two edges of the echo pin.
  kProbePulseTriggers,  ///< Trigger pulses of 5 us and of 11 us; answers 't'.
  kProbeDriveMotors,    ///< Left forward at OCR 191, right backward at 63; answers 'm'.
  kProbeSleepForEver,   ///< Sleeps with interrupts off.
  kProbeReadDevice,   ///< Reads registers 0x75, 0x76 at address 0x68; answers TWSR or data of each
                      ///< step, then TWSR of an address that nobody has.
  kProbeTimeTwoWire,  ///< Answers cycles (16 bit) of a byte at 400 kbit/s, interrupts of a START.
  kProbeReadVoltage,  ///< Answers the converter's last channel (16 bit).
  kProbeReleaseForward,   ///< The left motor's direction is an input with pull-up again: 'r'.
  kProbeReleaseOutputs,   ///< So are all of motors and servo; timers go on: 'r'.
  kProbePullUpTrigger,    ///< A pulse of 11 us by the trigger's pull-up: 't'.
  kProbeCountPinChanges,  ///< Answers interrupts of the first pin with pulses within 2 ms.
  kProbeDriveSpares,      ///< The first spare pin is a high output, the next has a pull-up: 'o'.
};
