// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/registers.hpp"

/// What a power cut forgets the last page of the flash keeps. Each power-up writes the next of its
/// half-words; the page is erased once in 512 power-ups, which it endures 10,000 times.
namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kFlashAddress = 0x08000000;
constexpr uint32_t kPageBytes = 1024;
/// The chip's flash in kB (RM0008, section 45.1). The family has parts of 16 kB on; the C8's is 64.
constexpr uint32_t kSizeRegister = 0x1FFFF7E0;
constexpr uint16_t kMinFlashKb = 16;
constexpr uint16_t kMaxFlashKb = 128;
constexpr uint16_t kUsualFlashKb = 64;
constexpr uint16_t kEntries = 512;
constexpr uint16_t kErased = 0xFFFF;

using HalfWord = volatile uint16_t;

uint32_t page_address() {
  const uint16_t told_kb = *reinterpret_cast<const HalfWord*>(kSizeRegister);
  const bool plausible = told_kb >= kMinFlashKb && told_kb <= kMaxFlashKb;
  const uint32_t flash_kb = plausible ? told_kb : kUsualFlashKb;
  return kFlashAddress + flash_kb * 1024U - kPageBytes;
}

HalfWord* entries() { return reinterpret_cast<HalfWord*>(page_address()); }

/// The core stands still meanwhile, so the bound is never met; QEMU has no busy bit.
void wait_while_busy() {
  for (uint16_t polls = UINT16_MAX; polls != 0 && (flash().sr & kFlashSrBusy) != 0; --polls) {
  }
}

void unlock() {
  flash().keyr = kFlashKey1;
  flash().keyr = kFlashKey2;
}

void erase_page() {
  flash().cr = kFlashCrPageErase;
  flash().ar = page_address();
  flash().cr = kFlashCrPageErase | kFlashCrStart;
  wait_while_busy();
}

void write(HalfWord& entry, uint16_t value) {
  flash().cr = kFlashCrProgram;
  entry = value;
  wait_while_busy();
}

}  // namespace

uint16_t count_power_up() {
  HalfWord* const entry = entries();
  uint16_t used = 0;
  while (used < kEntries && entry[used] != kErased) {
    ++used;
  }
  uint16_t number = used == 0 ? uint16_t{0} : entry[used - 1];
  number = number == kErased - 1 ? uint16_t{0} : static_cast<uint16_t>(number + 1);
  unlock();
  if (used == kEntries) {
    erase_page();
    used = 0;
  }
  write(entry[used], number);
  flash().cr = kFlashCrLock;
  return number;
}

}  // namespace boards
}  // namespace echomap
