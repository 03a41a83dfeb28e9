// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/usart.hpp"

#include <algorithm>
#include <utility>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kSr = 0x00;
constexpr std::uint32_t kDr = 0x04;
constexpr std::uint32_t kBrr = 0x08;
constexpr std::uint32_t kCr1 = 0x0C;

constexpr std::uint32_t kOverrun = bit(3);
constexpr std::uint32_t kReceived = bit(5);
constexpr std::uint32_t kSent = bit(6);
constexpr std::uint32_t kSendEmpty = bit(7);
constexpr std::uint32_t kReceiverOn = bit(2);
constexpr std::uint32_t kSenderOn = bit(3);
constexpr std::uint32_t kUsartOn = bit(13);
constexpr std::uint8_t kLine = 37;

constexpr std::uint64_t kBitsPerByte8N1 = 10;
/// A bit at 115200 baud, the pace of the receive wire while nobody listens.
constexpr std::uint64_t kDeafBitCycles = 625;

}  // namespace

void Usart::receive(std::span<const std::uint8_t> bytes) {
  const bool idle = on_wire_.empty();
  on_wire_.insert(on_wire_.end(), bytes.begin(), bytes.end());
  if (idle && !on_wire_.empty()) {
    wire_free_cycle_ = std::max(wire_free_cycle_, queue_.now());
    start_next_received();
  }
}

std::uint32_t Usart::read(std::uint32_t offset) {
  switch (offset) {
    case kSr:
      overrun_was_read_ = (sr_ & kOverrun) != 0;
      return sr_;
    case kDr:
      sr_ &= ~(kReceived | (std::exchange(overrun_was_read_, false) ? kOverrun : 0));
      update();
      return received_;
    case kBrr:
      return brr_;
    case kCr1:
      return cr1_;
    default:
      return 0;
  }
}

void Usart::write(std::uint32_t offset, std::uint32_t value) {
  const std::uint32_t sender = kUsartOn | kSenderOn;
  if (offset == kBrr) {
    brr_ = value;
  } else if (offset == kCr1) {
    cr1_ = value;
  } else if (offset == kDr && (cr1_ & sender) == sender && !to_send_) {
    if (sending_) {
      to_send_ = static_cast<std::uint8_t>(value);
      sr_ &= ~kSendEmpty;
    } else {
      sender_free_cycle_ = queue_.now();
      start_sending(static_cast<std::uint8_t>(value));
    }
  }
  update();
}

void Usart::reset() {
  sr_ = kSendEmpty | kSent;
  brr_ = 0;
  cr1_ = 0;
  sending_ = false;
  to_send_.reset();
  overrun_was_read_ = false;
  ++resets_;
  update();
}

std::uint64_t Usart::byte_cycles() const { return brr_ * kBitsPerByte8N1; }

bool Usart::receives() const {
  const std::uint32_t receiver = kUsartOn | kReceiverOn;
  return (cr1_ & receiver) == receiver && brr_ != 0;
}

void Usart::start_next_received() {
  wire_free_cycle_ += receives() ? byte_cycles() : kDeafBitCycles * kBitsPerByte8N1;
  queue_.at(wire_free_cycle_, [this] { take_received(); });
}

void Usart::take_received() {
  const std::uint8_t byte = on_wire_.front();
  on_wire_.pop_front();
  if (!on_wire_.empty()) {
    start_next_received();
  }
  if (!receives()) {
    return;
  }
  if ((sr_ & kReceived) != 0) {
    sr_ |= kOverrun;
  } else {
    received_ = byte;
    sr_ |= kReceived;
  }
  update();
}

void Usart::start_sending(std::uint8_t byte) {
  sending_ = true;
  sr_ &= ~kSent;
  sender_free_cycle_ += byte_cycles();
  queue_.at(sender_free_cycle_, [this, byte, reset = resets_] {
    if (reset == resets_) {
      end_sending(byte);
    }
  });
}

void Usart::end_sending(std::uint8_t byte) {
  sending_ = false;
  if (to_send_) {
    const std::uint8_t next = *to_send_;
    to_send_.reset();
    start_sending(next);
    sr_ |= kSendEmpty;
  } else {
    sr_ |= kSent;
  }
  update();
  if (on_sent) {
    on_sent(byte);
  }
}

/// Each enable bit of CR1 stands where its flag has its place in SR; an overrun counts as received.
void Usart::update() {
  const std::uint32_t flags = sr_ | ((sr_ & kOverrun) != 0 ? kReceived : 0);
  nvic_.set_line(kLine, (flags & cr1_ & (kReceived | kSent | kSendEmpty)) != 0);
}

}  // namespace echomap::unicorn
