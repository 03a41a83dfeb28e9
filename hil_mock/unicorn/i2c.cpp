// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/i2c.hpp"

#include <utility>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCr1 = 0x00;
constexpr std::uint32_t kCr2 = 0x04;
constexpr std::uint32_t kDr = 0x10;
constexpr std::uint32_t kSr1 = 0x14;
constexpr std::uint32_t kSr2 = 0x18;
constexpr std::uint32_t kCcr = 0x1C;
constexpr std::uint32_t kTrise = 0x20;

/// CR1.
constexpr std::uint32_t kEnable = bit(0);
constexpr std::uint32_t kStart = bit(8);
constexpr std::uint32_t kStop = bit(9);
constexpr std::uint32_t kAcknowledge = bit(10);
constexpr std::uint32_t kPosition = bit(11);
constexpr std::uint32_t kReset = bit(15);
/// CR2.
constexpr std::uint32_t kErrorInterrupt = bit(8);
constexpr std::uint32_t kEventInterrupt = bit(9);
constexpr std::uint32_t kBufferInterrupt = bit(10);
/// SR1.
constexpr std::uint32_t kStarted = bit(0);
constexpr std::uint32_t kAddressed = bit(1);
constexpr std::uint32_t kByteEnded = bit(2);
constexpr std::uint32_t kReceived = bit(6);
constexpr std::uint32_t kSendEmpty = bit(7);
constexpr std::uint32_t kNoAnswer = bit(10);
/// SR2.
constexpr std::uint32_t kMaster = bit(0);
constexpr std::uint32_t kBusy = bit(1);
constexpr std::uint32_t kSends = bit(2);

constexpr std::uint8_t kEventLine = 33;
constexpr std::uint8_t kErrorLine = 34;
constexpr unsigned kBitsOfByte = 9;  // with its acknowledge
constexpr std::uint32_t kFastMode = bit(15);
constexpr std::uint32_t kCcrCount = 0xFFF;
constexpr std::uint64_t kCyclesPerBusClock = 2;

}  // namespace

std::uint32_t I2c::read(std::uint32_t offset) {
  switch (offset) {
    case kCr1:
      return cr1_;
    case kCr2:
      return cr2_;
    case kDr:
      return read_data();
    case kSr1:
      seen_ = sr1_;
      return sr1_;
    case kSr2:
      return read_status2();
    case kCcr:
      return ccr_;
    case kTrise:
      return trise_;
    default:
      return 0;
  }
}

void I2c::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCr1) {
    write_control(value);
  } else if (offset == kCr2) {
    cr2_ = value;
  } else if (offset == kDr) {
    write_data(static_cast<std::uint8_t>(value));
  } else if (offset == kSr1) {
    sr1_ &= value | ~kNoAnswer;
  } else if (offset == kCcr) {
    ccr_ = value;
  } else if (offset == kTrise) {
    trise_ = value;
  }
  update();
}

void I2c::reset() {
  cr2_ = 0;
  ccr_ = 0;
  trise_ = 0;
  write_control(0);
  update();
}

void I2c::write_control(std::uint32_t value) {
  const std::uint32_t asked = value & ~cr1_;
  cr1_ = value;
  if ((value & kEnable) == 0 || (value & kReset) != 0) {
    ++transfers_;
    sr1_ = 0;
    sr2_ = 0;
    to_send_.reset();
    sending_ = false;
    device_speaks_ = false;
    return;
  }
  if ((asked & kStop) != 0) {
    after(1, [this] { stop(); });
  } else if ((asked & kStart) != 0) {
    after(1, [this] { start(); });
  }
}

/// A byte for DR while the unit sends waits for the one under way.
void I2c::write_data(std::uint8_t byte) {
  if ((sr1_ & seen_ & kStarted) != 0) {
    sr1_ &= ~kStarted;
    after(kBitsOfByte, [this, byte] { end_address(byte); });
  } else if (sends()) {
    sr1_ &= ~(kByteEnded | kSendEmpty);
    if (sending_) {
      to_send_ = byte;
    } else {
      begin_sending(byte);
    }
  }
}

std::uint32_t I2c::read_data() {
  const std::uint8_t byte = data_;
  if ((sr1_ & kByteEnded) != 0 && !sends()) {
    sr1_ &= ~kByteEnded;
    data_ = shifted_;
    if (std::exchange(device_speaks_, false)) {
      begin_receiving();
    }
  } else {
    sr1_ &= ~kReceived;
  }
  update();
  return byte;
}

std::uint32_t I2c::read_status2() {
  if ((sr1_ & seen_ & kAddressed) != 0) {
    sr1_ &= ~kAddressed;
    if (sends()) {
      sr1_ |= kSendEmpty;
    } else {
      acknowledges_next_ = (cr1_ & kAcknowledge) != 0;
      begin_receiving();
    }
    update();
  }
  return sr2_;
}

std::uint64_t I2c::bit_cycles() const {
  const std::uint64_t count = ccr_ & kCcrCount;
  return kCyclesPerBusClock * count * ((ccr_ & kFastMode) != 0 ? 3 : 2);
}

void I2c::after(unsigned bits, std::function<void()> step) {
  if (!has_pins || !has_pins()) {
    return;
  }
  queue_.at(queue_.now() + bits * bit_cycles(),
            [this, step = std::move(step), transfer = transfers_] {
              if (transfer == transfers_ && !held_) {
                step();
                update();
              }
            });
}

void I2c::start() {
  cr1_ &= ~kStart;
  if (device_speaks_) {
    return;
  }
  sr1_ = kStarted;
  seen_ = 0;
  sr2_ = kMaster | kBusy;
}

void I2c::stop() {
  if (device_speaks_) {
    return;
  }
  cr1_ &= ~kStop;
  sr1_ &= ~(kByteEnded | kSendEmpty);
  sr2_ = 0;
}

void I2c::end_address(std::uint8_t byte) {
  const bool reads = (byte & 1U) != 0;
  if (device_ == nullptr || device_->address() != byte >> 1) {
    sr1_ |= kNoAnswer;
    return;
  }
  sr1_ |= kAddressed;
  sr2_ = kMaster | kBusy | (reads ? 0 : kSends);
  register_is_next_ = !reads;
}

void I2c::begin_sending(std::uint8_t byte) {
  sending_ = true;
  sr1_ |= kSendEmpty;
  after(kBitsOfByte, [this, byte] { end_sending(byte); });
}

void I2c::end_sending(std::uint8_t byte) {
  if (std::exchange(register_is_next_, false)) {
    register_ = byte;
  } else {
    device_->write(register_++, byte);
  }
  sending_ = false;
  if (const auto next = std::exchange(to_send_, std::nullopt)) {
    begin_sending(*next);
  } else {
    sr1_ |= kByteEnded;
  }
}

void I2c::begin_receiving() {
  after(kBitsOfByte, [this] { end_receiving(); });
}

/// With POS the bit ACK is of the byte after the one under way.
void I2c::end_receiving() {
  const bool now = (cr1_ & kAcknowledge) != 0;
  const bool acknowledged = (cr1_ & kPosition) != 0 ? acknowledges_next_ : now;
  acknowledges_next_ = now;
  const std::uint8_t byte = device_->read(register_++);
  if ((sr1_ & kReceived) != 0) {
    shifted_ = byte;
    sr1_ |= kByteEnded;
    device_speaks_ = acknowledged;
    return;
  }
  data_ = byte;
  sr1_ |= kReceived;
  if (acknowledged) {
    begin_receiving();
  }
}

bool I2c::sends() const { return (sr2_ & kSends) != 0; }

void I2c::update() {
  const std::uint32_t buffer = (cr2_ & kBufferInterrupt) != 0 ? kReceived | kSendEmpty : 0;
  const bool event = (sr1_ & (kStarted | kAddressed | kByteEnded | buffer)) != 0;
  nvic_.set_line(kEventLine, event && (cr2_ & kEventInterrupt) != 0);
  nvic_.set_line(kErrorLine, (sr1_ & kNoAnswer) != 0 && (cr2_ & kErrorInterrupt) != 0);
}

}  // namespace echomap::unicorn
