// SPDX-License-Identifier: MIT
#include "firmware/hal/twi.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"
#include "firmware/boards/rp2040/vectors.hpp"

/// I2C0 takes a whole transfer into its FIFO and interrupts once, when the bus is free again.
namespace echomap {
namespace boards {
namespace {

using hal::TwiState;

constexpr uint32_t kReadBytes = 2;

volatile TwiState state = TwiState::kIdle;
bool on;
bool reads;
volatile int16_t answer;

void wait_half_clock() {
  constexpr uint32_t kHalfUs = 5;
  const uint32_t start = timer().timerawl;
  while (timer().timerawl - start <= kHalfUs) {
  }
}

/// Low is driven, high is let go.
void drive_clock(bool high) { (high ? sio().oe_clr : sio().oe_set) = bit(kTwiClockPin); }

/// A device that was given up in the middle of a byte holds SDA low until it has sent the rest of
/// it: nine clocks at most, then it finds no acknowledge (NXP UM10204, 3.1.16).
void free_bus() {
  pull_up(kTwiDataPin);
  pull_up(kTwiClockPin);
  set_level(kTwiClockPin, false);
  wait_half_clock();
  for (uint8_t clocks = 9; clocks != 0 && !level_of(kTwiDataPin); --clocks) {
    drive_clock(false);
    wait_half_clock();
    drive_clock(true);
    wait_half_clock();
  }
}

/// Switched off in the middle of a transfer, the unit may stay active: only a reset ends that.
///
/// 4.3.14: 400 kbit/s are 312 cycles of 8 ns, low for 1.5 us of 2.5; SDA holds for 300 ns, and
/// spikes of up to 88 ns are none.
void take_bus() {
  free_bus();
  reset_parts(kResetI2c0);
  i2c0().con = kI2cConMaster | kI2cConFast | kI2cConRestart | kI2cConNoSlave;
  i2c0().fs_scl_lcnt = 187;
  i2c0().fs_scl_hcnt = 125;
  i2c0().fs_spklen = 11;
  i2c0().sda_hold = 38;
  i2c0().intr_mask = kI2cAborted | kI2cStopped;
  set_function(kTwiDataPin, PinFunction::kI2c);
  set_function(kTwiClockPin, PinFunction::kI2c);
  enable_line(InterruptLine::kI2c0);
  on = true;
}

/// The address can be changed only while the unit is off.
void start(uint8_t address, bool read) {
  if (!on) {
    take_bus();
  }
  reads = read;
  state = TwiState::kBusy;
  i2c0().enable = 0;
  i2c0().tar = address;
  static_cast<void>(i2c0().clr_intr);
  i2c0().enable = 1;
}

void take_stop() {
  if (state != TwiState::kBusy) {
    return;
  }
  if (!reads) {
    state = TwiState::kDone;
  } else if (i2c0().rxflr == kReadBytes) {
    const uint32_t high = i2c0().data_cmd & 0xFF;
    answer = static_cast<int16_t>(high << 8 | (i2c0().data_cmd & 0xFF));
    state = TwiState::kDone;
  } else {
    state = TwiState::kFailed;
  }
}

}  // namespace
}  // namespace boards

namespace hal {

bool has_twi() { return true; }

void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value) {
  using namespace boards;
  start(address, false);
  i2c0().data_cmd = device_register;
  i2c0().data_cmd = value | kI2cStop;
}

void start_twi_read(uint8_t address, uint8_t device_register) {
  using namespace boards;
  start(address, true);
  i2c0().data_cmd = device_register;
  i2c0().data_cmd = kI2cRead | kI2cRestart;
  i2c0().data_cmd = kI2cRead | kI2cStop;
}

TwiState twi_state(int16_t& value) {
  const TwiState state = boards::state;
  if (state == TwiState::kDone) {
    value = boards::answer;
  }
  return state;
}

void stop_twi() {
  if (!boards::on) {
    return;
  }
  boards::i2c0().intr_mask = 0;
  boards::i2c0().enable = 0;
  boards::pull_up(boards::kTwiClockPin);
  boards::pull_up(boards::kTwiDataPin);
  boards::on = false;
  boards::state = TwiState::kIdle;
}

}  // namespace hal
}  // namespace echomap

/// An abort, of a device that does not answer or of a bus that does what it must not, ends with a
/// stop, too.
extern "C" void on_i2c0() {
  using namespace echomap;
  const uint32_t status = boards::i2c0().intr_stat;
  if ((status & boards::kI2cAborted) != 0) {
    static_cast<void>(boards::i2c0().clr_tx_abrt);
    boards::state = hal::TwiState::kFailed;
  }
  if ((status & boards::kI2cStopped) != 0) {
    static_cast<void>(boards::i2c0().clr_stop_det);
    boards::take_stop();
  }
}
