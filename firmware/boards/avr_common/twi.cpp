// SPDX-License-Identifier: MIT
#include "firmware/hal/twi.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <util/delay.h>
#include <util/twi.h>

#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

using hal::TwiState;

/// 400 kbit/s: 16 MHz / (16 + 2 x 12).
constexpr uint8_t kBitRate = (F_CPU / 400000 - 16) / 2;

constexpr uint8_t kGoOn = _BV(TWEN) | _BV(TWIE) | _BV(TWINT);
constexpr uint8_t kStart = kGoOn | _BV(TWSTA);
constexpr uint8_t kOneMore = kGoOn | _BV(TWEA);
constexpr uint8_t kStop = _BV(TWEN) | _BV(TWINT) | _BV(TWSTO);

volatile TwiState state = TwiState::kIdle;
bool reads;
/// Address, register, and a value to write or the address to read from.
uint8_t bytes[3];
uint8_t sent;
volatile uint8_t high_byte;
volatile uint8_t low_byte;

/// A device that was given up in the middle of a byte holds SDA low until it has sent the rest of
/// it: nine clocks at most, then it finds no acknowledge (NXP UM10204, 3.1.16).
void free_bus() {
  for (uint8_t clocks = 9; clocks != 0 && sda_is_low(); --clocks) {
    hold_scl();
    _delay_us(5);
    release_scl();
    _delay_us(5);
  }
}

void start(uint8_t address, uint8_t device_register) {
  if ((TWCR & _BV(TWEN)) == 0) {
    free_bus();
  }
  bytes[0] = static_cast<uint8_t>(address << 1);
  bytes[1] = device_register;
  sent = 0;
  state = TwiState::kBusy;
  TWBR = kBitRate;
  asm volatile("" ::: "memory");  // The interrupt finds all of it stored.
  TWCR = kStart;
}

/// Takes the step that the bus is ready for; the next one.
uint8_t next_step() {
  switch (TW_STATUS) {
    case TW_MT_SLA_ACK:
    case TW_MT_DATA_ACK:
      if (sent == 3) {
        state = TwiState::kDone;
        return kStop;
      }
      if (sent == 2 && reads) {
        return kStart;
      }
      TWDR = bytes[sent++];
      return kGoOn;
    case TW_START:
    case TW_REP_START:
      TWDR = bytes[sent++];
      return kGoOn;
    case TW_MR_SLA_ACK:
      return kOneMore;
    case TW_MR_DATA_ACK:
      high_byte = TWDR;
      return kGoOn;
    case TW_MR_DATA_NACK:
      low_byte = TWDR;
      state = TwiState::kDone;
      return kStop;
    default:
      state = TwiState::kFailed;
      return kStop;
  }
}

}  // namespace
}  // namespace boards

namespace hal {

bool has_twi() { return true; }

void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value) {
  boards::reads = false;
  boards::bytes[2] = value;
  boards::start(address, device_register);
}

void start_twi_read(uint8_t address, uint8_t device_register) {
  boards::reads = true;
  boards::bytes[2] = static_cast<uint8_t>((address << 1) | TW_READ);
  boards::start(address, device_register);
}

TwiState twi_state(int16_t& value) {
  const TwiState state = boards::state;
  if (state == TwiState::kDone) {  // Before that, the interrupt still writes to the bytes.
    value = static_cast<int16_t>((boards::high_byte << 8) | boards::low_byte);
  }
  return state;
}

void stop_twi() {
  TWCR = 0;
  boards::state = TwiState::kIdle;
}

ISR(TWI_vect) { TWCR = boards::next_step(); }

}  // namespace hal
}  // namespace echomap
