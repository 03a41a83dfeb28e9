// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/flash_writer.hpp"

#include <algorithm>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kAcr = 0x00;
constexpr std::uint32_t kKeyr = 0x04;
constexpr std::uint32_t kSr = 0x0C;
constexpr std::uint32_t kCr = 0x10;
constexpr std::uint32_t kAr = 0x14;

constexpr std::uint32_t kKey1 = 0x45670123;
constexpr std::uint32_t kKey2 = 0xCDEF89AB;
constexpr std::uint32_t kProgram = bit(0);
constexpr std::uint32_t kPageErase = bit(1);
constexpr std::uint32_t kStart = bit(6);
constexpr std::uint32_t kLock = bit(7);
constexpr std::uint32_t kProgramError = bit(2);
constexpr std::uint32_t kPageBytes = 1024;

constexpr std::uint64_t kProgramCycles = 3'816;    // 53 us
constexpr std::uint64_t kEraseCycles = 1'440'000;  // 20 ms

}  // namespace

std::uint32_t FlashWriter::read_data(std::uint32_t offset, unsigned size) const {
  const std::uint32_t low = data_[offset / 2];
  if (size == 4) {
    return low | std::uint32_t{data_[offset / 2 + 1]} << 16;
  }
  return size == 2 ? low : low >> (8 * (offset % 2)) & 0xFFU;
}

void FlashWriter::write_data(std::uint32_t offset, unsigned size, std::uint32_t value) {
  const bool allowed = (cr_ & (kLock | kProgram)) == kProgram && size == 2;
  if (!allowed || data_[offset / 2] != kErased) {
    sr_ |= kProgramError;
    return;
  }
  data_[offset / 2] = static_cast<std::uint16_t>(value);
  queue_.spend(kProgramCycles);
}

std::uint32_t FlashWriter::read(std::uint32_t offset) {
  switch (offset) {
    case kAcr:
      return acr_;
    case kSr:
      return sr_;
    case kCr:
      return cr_;
    case kAr:
      return ar_;
    default:
      return 0;
  }
}

void FlashWriter::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kAcr) {
    acr_ = value;
  } else if (offset == kKeyr) {
    take_key(value);
  } else if (offset == kSr) {
    sr_ &= ~value;
  } else if (offset == kAr) {
    ar_ = value;
  } else if (offset == kCr && (cr_ & kLock) == 0) {
    cr_ = value;
    if ((cr_ & (kPageErase | kStart)) == (kPageErase | kStart)) {
      erase_page();
    }
  }
}

void FlashWriter::reset() {
  acr_ = sr_ = ar_ = 0;
  cr_ = kLock;
  first_key_ = false;
}

void FlashWriter::take_key(std::uint32_t key) {
  if (first_key_ && key == kKey2) {
    cr_ &= ~kLock;
  }
  first_key_ = key == kKey1;
}

void FlashWriter::erase_page() {
  cr_ &= ~kStart;
  const std::uint32_t page = (ar_ - kDataAddress) / kPageBytes;
  if (page < kDataBytes / kPageBytes) {
    std::fill_n(data_.begin() + page * kPageBytes / 2, kPageBytes / 2, kErased);
  }
  queue_.spend(kEraseCycles);
}

}  // namespace echomap::unicorn
