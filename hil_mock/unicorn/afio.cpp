// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/afio.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kMapr = 0x04;
constexpr std::uint32_t kFirstExticr = 0x08;
constexpr std::uint32_t kExticrBytes = 0x10;
constexpr std::uint32_t kTim2OnA15AndB3 = bit(8);
/// SWJ_CFG: a program writes it and reads nonsense.
constexpr unsigned kDebugPortShift = 24;
constexpr std::uint32_t kDebugPortBits = 7U << kDebugPortShift;
constexpr unsigned kJtag = 0;
constexpr unsigned kJtagWithoutReset = 1;

}  // namespace

bool Afio::tim2_is_on_a15_and_b3() const { return (mapr_ & kTim2OnA15AndB3) != 0; }

std::uint32_t Afio::jtag_pins_of_a() const {
  return debug_port() <= kJtagWithoutReset ? bit(15) : 0;
}

std::uint32_t Afio::jtag_pins_of_b() const {
  if (debug_port() == kJtag) {
    return bit(3) | bit(4);
  }
  return debug_port() == kJtagWithoutReset ? bit(3) : 0;
}

unsigned Afio::port_of_line(std::uint8_t line) const {
  return exticr_.at(line / 4U) >> (line % 4U * 4U) & 0xFU;
}

std::uint32_t Afio::read(std::uint32_t offset) {
  if (offset - kFirstExticr < kExticrBytes) {
    return exticr_.at((offset - kFirstExticr) / 4);
  }
  return offset == kMapr ? mapr_ & ~kDebugPortBits : 0;
}

void Afio::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kMapr) {
    set_mapr(value);
  } else if (offset - kFirstExticr < kExticrBytes) {
    exticr_.at((offset - kFirstExticr) / 4) = value;
  }
}

void Afio::reset() {
  exticr_ = {};
  set_mapr(0);
}

unsigned Afio::debug_port() const { return (mapr_ & kDebugPortBits) >> kDebugPortShift; }

void Afio::set_mapr(std::uint32_t value) {
  mapr_ = value;
  if (on_remap) {
    on_remap();
  }
}

}  // namespace echomap::unicorn
