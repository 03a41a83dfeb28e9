// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// One value for one register.
struct Setting {
  uint32_t address;
  uint32_t value;
};

/// The second stage of the boot: sets up the flash to be read like memory by command 03h, which
/// every flash chip has (SSI, RP2040 data sheet 4.10.13), then starts the program. A few words of
/// machine code go through a table of settings, wherever they stand; an address of 0 ends it.
struct Boot2 {
  static constexpr uint8_t kCodeHalfWords = 18;
  static constexpr uint8_t kSettings = 8;
  static constexpr uint8_t kWords = 63;  ///< The 64th is the checksum.

  uint32_t word[kWords];
  uint32_t checksum;

  constexpr Boot2() : word(), checksum(0) {
    constexpr uint16_t kCode[kCodeHalfWords] = {
        0xA308,  //   add r3, pc, #32: the table
        0xCB03,  // next: ldmia r3!, {r0, r1}
        0x2800,  //   cmp r0, #0
        0xD001,  //   beq done
        0x6001,  //   str r1, [r0]
        0xE7FA,  //   b next
        0x4670,  // done: mov r0, lr
        0x2800,  //   cmp r0, #0
        0xD000,  //   beq start
        0x4770,  //   bx lr: called by a program that had used the flash otherwise
        0x6808,  // start: ldr r0, [r1]
        0xF380,
        0x8808,  //   msr msp, r0
        0x6848,  //   ldr r0, [r1, #4]
        0x4700,  //   bx r0
        0xBF00,
        0xBF00,
        0xBF00,
    };
    constexpr uint32_t kSsi = 0x18000000;
    constexpr uint32_t kVectors = 0x10000100;
    constexpr Setting kTable[kSettings] = {
        {kSsi + 0x08, 0},           // SSIENR: off.
        {kSsi + 0x14, 2},           // BAUDR: half of the clock, which is the slow one still.
        {kSsi + 0x00, 0x001F0300},  // CTRLR0: 32 bits at a time, command and address before them.
        {kSsi + 0xF4, 0x03000218},  // SPI_CTRLR0: command 03h of 8 bits, address of 24.
        {kSsi + 0x04, 0},           // CTRLR1: one at a time.
        {kSsi + 0x08, 1},           // SSIENR: on.
        {0xE000ED08, kVectors},     // VTOR.
        {0, kVectors},
    };
    for (uint8_t i = 0; i < kCodeHalfWords / 2; ++i) {
      word[i] = kCode[2 * i] | uint32_t{kCode[2 * i + 1]} << 16;
    }
    for (uint8_t i = 0; i < kSettings; ++i) {
      word[kCodeHalfWords / 2 + 2 * i] = kTable[i].address;
      word[kCodeHalfWords / 2 + 2 * i + 1] = kTable[i].value;
    }
    checksum = crc();
  }

 private:
  /// 2.8.1.3.1: CRC-32 of 04C11DB7, from all ones, highest bit first, not inverted; bytes in order.
  constexpr uint32_t crc() const {
    uint32_t remainder = 0xFFFFFFFF;
    for (uint8_t byte = 0; byte < kWords * 4; ++byte) {
      const uint32_t value = word[byte / 4] >> (byte % 4 * 8) & 0xFF;
      remainder ^= value << 24;
      for (uint8_t bits = 0; bits < 8; ++bits) {
        const bool carry = (remainder & 0x80000000) != 0;
        remainder = carry ? remainder << 1 ^ 0x04C11DB7 : remainder << 1;
      }
    }
    return remainder;
  }
};
static_assert(sizeof(Boot2) == 256, "what the chip reads");

}  // namespace boards
}  // namespace echomap
