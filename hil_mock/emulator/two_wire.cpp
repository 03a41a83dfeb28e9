// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/two_wire.hpp"

#include <algorithm>
#include <sim_interrupts.h>
#include <sim_regbit.h>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
namespace {

/// TWCR.
enum Control : unsigned {
  kInterrupt = 0x80,
  kAcknowledge = 0x40,
  kStart = 0x20,
  kStop = 0x10,
  kEnable = 0x04,
};

/// TWSR without its prescaler bits.
enum Status : std::uint8_t {
  kStarted = 0x08,
  kRestarted = 0x10,
  kAddressWriteAck = 0x18,
  kAddressWriteNack = 0x20,
  kWriteAck = 0x28,
  kWriteNack = 0x30,
  kAddressReadAck = 0x40,
  kAddressReadNack = 0x48,
  kReadAck = 0x50,
  kReadNack = 0x58,
  kNothing = 0xF8,
};

constexpr unsigned kPrescaler = 0x03;
constexpr unsigned kBitsOfByte = 9;  // with its acknowledge

}  // namespace

TwoWire::TwoWire(avr_t& avr, RegisterHooks& hooks, CycleQueue& queue)
    : avr_(avr), twi_(find_two_wire(avr)), queue_(queue) {
  hooks.replace_write(twi_.r_twcr, [this](std::uint8_t value) { write_control(value); });
  hooks.replace_write(twi_.r_twdr, [this](std::uint8_t value) { avr_.data[twi_.r_twdr] = value; });
  hooks.replace_write(twi_.r_twsr, [this](std::uint8_t value) {
    std::uint8_t& status = avr_.data[twi_.r_twsr];
    status = static_cast<std::uint8_t>((status & ~kPrescaler) | (value & kPrescaler));
  });
}

void TwoWire::reset() {
  ++transfer_;
  phase_ = Phase::kIdle;
  free_cycle_ = 0;
  set_status(kNothing);
}

void TwoWire::write_control(std::uint8_t value) {
  std::uint8_t& control = avr_.data[twi_.r_twcr];
  const bool waits = (control & kInterrupt) != 0;
  const bool enabled = (value & kEnable) != 0;
  const bool goes_on = (value & kInterrupt) != 0;
  control = static_cast<std::uint8_t>(value & ~kInterrupt);
  avr_clear_interrupt(&avr_, &twi_.twi);
  if (!enabled) {
    reset();
  } else if (goes_on) {
    begin(value);
  } else if (waits) {
    avr_raise_interrupt(&avr_, &twi_.twi);
  }
}

void TwoWire::begin(std::uint8_t control) {
  ++transfer_;
  if ((control & kStop) != 0) {
    begin_stop();
  }
  if ((control & kStart) != 0) {
    begin_start();
    return;
  }
  const std::uint8_t data = avr_.data[twi_.r_twdr];
  switch (phase_) {
    case Phase::kAddress:
      begin_address(data);
      break;
    case Phase::kRegister:
    case Phase::kWrite:
      begin_write(data);
      break;
    case Phase::kRead:
      begin_read((control & kAcknowledge) != 0);
      break;
    case Phase::kRefused:
      end_after(kBitsOfByte, kWriteNack);
      break;
    case Phase::kIdle:
      break;
  }
}

void TwoWire::begin_start() {
  const bool again = phase_ != Phase::kIdle;
  phase_ = Phase::kAddress;
  end_after(1, again ? kRestarted : kStarted);
}

/// Ends without an interrupt; TWSTO then clears itself.
void TwoWire::begin_stop() {
  phase_ = Phase::kIdle;
  set_status(kNothing);
  free_cycle_ = std::max<std::uint64_t>(free_cycle_, avr_.cycle) + bit_cycles();
  queue_.at(free_cycle_, [this, transfer = transfer_] {
    if (transfer == transfer_) {
      std::uint8_t& control = avr_.data[twi_.r_twcr];
      control = static_cast<std::uint8_t>(control & ~kStop);
    }
  });
}

void TwoWire::begin_address(std::uint8_t address_byte) {
  const bool reads = (address_byte & 1U) != 0;
  const bool answers = device_ != nullptr && device_->address() == address_byte >> 1U;
  if (!answers) {
    phase_ = Phase::kRefused;
    end_after(kBitsOfByte, reads ? kAddressReadNack : kAddressWriteNack);
    return;
  }
  phase_ = reads ? Phase::kRead : Phase::kRegister;
  end_after(kBitsOfByte, reads ? kAddressReadAck : kAddressWriteAck);
}

void TwoWire::begin_write(std::uint8_t byte) {
  if (phase_ == Phase::kRegister) {
    device_register_ = byte;
    phase_ = Phase::kWrite;
  } else {
    device_->write(device_register_++, byte);
  }
  end_after(kBitsOfByte, kWriteAck);
}

void TwoWire::begin_read(bool acknowledge) {
  avr_.data[twi_.r_twdr] = device_->read(device_register_++);
  end_after(kBitsOfByte, acknowledge ? kReadAck : kReadNack);
}

void TwoWire::end_after(unsigned bits, std::uint8_t status) {
  free_cycle_ = std::max<std::uint64_t>(free_cycle_, avr_.cycle) + bits * bit_cycles();
  queue_.at(free_cycle_, [this, status, transfer = transfer_] {
    if (transfer == transfer_ && !held_) {
      set_status(status);
      avr_raise_interrupt(&avr_, &twi_.twi);
    }
  });
}

void TwoWire::set_status(std::uint8_t status) {
  std::uint8_t& with_prescaler = avr_.data[twi_.r_twsr];
  with_prescaler = static_cast<std::uint8_t>((with_prescaler & kPrescaler) | status);
}

/// Data sheet, section 22.5.2: 16 + 2 TWBR 4^TWPS cycles.
std::uint64_t TwoWire::bit_cycles() const {
  const unsigned prescaler = 1U << (2U * (avr_.data[twi_.r_twsr] & kPrescaler));
  return 16U + 2U * avr_.data[twi_.r_twbr] * prescaler;
}

}  // namespace echomap::emulator
