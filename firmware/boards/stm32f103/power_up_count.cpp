// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/registers.hpp"

/// What a power cut forgets a page of the flash keeps. Each power-up writes the next of its
/// half-words; the page is erased once in 512 power-ups, which it endures 10,000 times.
namespace echomap {
namespace boards {
namespace {

/// The last page of 32 kB, which the smallest part that the image fits into (F103x6) has, too.
constexpr uint32_t kPageAddress = 0x08007C00;
constexpr uint16_t kEntries = 512;
constexpr uint16_t kErased = 0xFFFF;

using HalfWord = volatile uint16_t;

HalfWord* entries() { return reinterpret_cast<HalfWord*>(kPageAddress); }

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
  flash().ar = kPageAddress;
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
