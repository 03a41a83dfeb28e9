// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/adc.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kSr = 0x00;
constexpr std::uint32_t kCr2 = 0x08;
constexpr std::uint32_t kSqr3 = 0x34;
constexpr std::uint32_t kDr = 0x4C;
constexpr std::uint32_t kDone = bit(1);
constexpr std::uint32_t kOn = bit(0);
constexpr std::uint32_t kCalibrations = bit(2) | bit(3);
constexpr std::uint32_t kStart = bit(22);
constexpr std::uint32_t kChannelBits = 0x1F;
constexpr std::uint64_t kConversionCycles = 408;  // 68 of 12 MHz

}  // namespace

std::uint32_t Adc::read(std::uint32_t offset) {
  switch (offset) {
    case kSr:
      return sr_;
    case kCr2:
      return cr2_;
    case kSqr3:
      return channel_;
    case kDr:
      sr_ &= ~kDone;
      return dr_;
    default:
      return 0;
  }
}

void Adc::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kSr) {
    sr_ &= value;
  } else if (offset == kSqr3) {
    channel_ = value & kChannelBits;
  } else if (offset == kCr2) {
    cr2_ = value & ~(kStart | kCalibrations);  // A calibration is over at once.
    if ((value & (kStart | kOn)) == (kStart | kOn)) {
      convert();
    }
  }
}

void Adc::reset() {
  sr_ = cr2_ = channel_ = dr_ = 0;
  ++conversions_;
}

void Adc::convert() {
  queue_.at(queue_.now() + kConversionCycles, [this, conversion = ++conversions_] {
    if (conversion == conversions_) {
      dr_ = channel_ < inputs_.size() ? inputs_[channel_] : 0;
      sr_ |= kDone;
    }
  });
}

}  // namespace echomap::unicorn
