// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

/// Data-space addresses of the registers that the emulator looks at.
/// Source: Microchip DS40002061B (ATmega328P), chapter 30 "Register Summary".
namespace echomap::emulator::atmega328p {

/// Addresses in the data space.
constexpr std::uint16_t kPinB = 0x23;
constexpr std::uint16_t kPinC = 0x26;
constexpr std::uint16_t kPinD = 0x29;
constexpr std::uint16_t kPortD = 0x2B;
constexpr std::uint16_t kTifr0 = 0x35;
constexpr std::uint16_t kTifr1 = 0x36;
constexpr std::uint16_t kTifr2 = 0x37;
constexpr std::uint16_t kPcifr = 0x3B;
constexpr std::uint16_t kEifr = 0x3C;
constexpr std::uint16_t kEimsk = 0x3D;
constexpr std::uint16_t kTccr0a = 0x44;
constexpr std::uint16_t kTccr0b = 0x45;
constexpr std::uint16_t kOcr0a = 0x47;
constexpr std::uint16_t kOcr0b = 0x48;
constexpr std::uint16_t kPcicr = 0x68;
constexpr std::uint16_t kTimsk0 = 0x6E;
constexpr std::uint16_t kTimsk1 = 0x6F;
constexpr std::uint16_t kTimsk2 = 0x70;
constexpr std::uint16_t kTccr1a = 0x80;
constexpr std::uint16_t kOcr1bl = 0x8A;
constexpr std::uint16_t kOcr1bh = 0x8B;
constexpr std::uint16_t kUcsr0b = 0xC1;

/// First byte of SRAM and the number of its bytes.
constexpr std::uint16_t kSramStart = 0x100;
constexpr std::uint16_t kSramBytes = 2048;

}  // namespace echomap::emulator::atmega328p
