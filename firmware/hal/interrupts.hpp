// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Locks interrupts and returns the state to give back to `restore_interrupts`.
uint8_t lock_interrupts();
void restore_interrupts(uint8_t state);

/// Lets interrupts happen, once the program has started.
void enable_interrupts();

/// Called with interrupts locked: unlocks them and sleeps until one has been served. None can slip
/// in between the two, so a flag checked under the lock is not slept through.
void sleep_until_interrupt();

/// Interrupts are locked while it lives.
class InterruptLock {
 public:
  __attribute__((always_inline)) InterruptLock() : state_(lock_interrupts()) {}
  __attribute__((always_inline)) ~InterruptLock() { restore_interrupts(state_); }
  InterruptLock(const InterruptLock&) = delete;
  InterruptLock& operator=(const InterruptLock&) = delete;

 private:
  uint8_t state_;
};

}  // namespace hal
}  // namespace echomap
