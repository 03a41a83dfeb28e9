// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/usart0.hpp"

#include <algorithm>
#include <sim_interrupts.h>
#include <sim_io.h>
#include <sim_regbit.h>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
namespace {

/// Two bytes of buffer and the shift register: ATmega328P data sheet, section 20.7.
constexpr std::size_t kReceiveDepth = 3;
constexpr std::uint64_t kBitsPerByte8N1 = 10;
/// A byte at 115200 baud, the pace of the receive wire while nobody listens.
constexpr std::uint64_t kDeafByteCycles = 1389;

}  // namespace

Usart0::Usart0(avr_t& avr, RegisterHooks& hooks, CycleQueue& queue)
    : avr_(avr), uart_(find_uart(avr, '0')), queue_(queue) {
  uart_.flags = 0;  // neither prints lines nor waits on wall time
  hooks.replace_read(uart_.r_udr, [this] { return read_data(); });
  hooks.replace_write(uart_.r_udr, [this](std::uint8_t byte) { write_data(byte); });
  hooks.after_write(uart_.r_ucsrb, [this] {
    if (!receiver_enabled()) {
      drop_unread();
    }
  });
}

void Usart0::receive(std::span<const std::uint8_t> bytes) {
  const bool idle = on_wire_.empty();
  on_wire_.insert(on_wire_.end(), bytes.begin(), bytes.end());
  if (idle && !on_wire_.empty()) {
    wire_free_cycle_ = std::max<std::uint64_t>(wire_free_cycle_, avr_.cycle);
    start_next_received();
  }
}

void Usart0::reset() {
  drop_unread();
  ++resets_;
  sending_ = false;
  to_send_.reset();
  avr_regbit_set(&avr_, uart_.udrc.raised);
}

std::uint64_t Usart0::byte_cycles() const {
  const unsigned low = avr_regbit_get(&avr_, uart_.ubrrl);
  const unsigned high = avr_regbit_get(&avr_, uart_.ubrrh);
  const std::uint64_t divider = (high << 8U | low) + 1;
  const std::uint64_t samples_per_bit = avr_regbit_get(&avr_, uart_.u2x) != 0 ? 8 : 16;
  return divider * samples_per_bit * kBitsPerByte8N1;
}

bool Usart0::receiver_enabled() const { return avr_regbit_get(&avr_, uart_.rxen) != 0; }

void Usart0::start_next_received() {
  wire_free_cycle_ += receiver_enabled() ? byte_cycles() : kDeafByteCycles;
  queue_.at(wire_free_cycle_, [this] { take_received(); });
}

void Usart0::take_received() {
  const std::uint8_t byte = on_wire_.front();
  on_wire_.pop_front();
  if (!on_wire_.empty()) {
    start_next_received();
  }
  if (!receiver_enabled()) {
    return;
  }
  if (unread_.size() == kReceiveDepth) {
    avr_regbit_set(&avr_, uart_.dor);
    return;
  }
  unread_.push_back(byte);
  avr_raise_interrupt(&avr_, &uart_.rxc);
}

std::uint8_t Usart0::read_data() {
  if (unread_.empty()) {
    return 0;
  }
  const std::uint8_t byte = unread_.front();
  unread_.pop_front();
  avr_regbit_clear(&avr_, uart_.dor);
  if (unread_.empty()) {
    drop_unread();
  } else {
    avr_raise_interrupt(&avr_, &uart_.rxc);
  }
  return byte;
}

void Usart0::drop_unread() {
  unread_.clear();
  avr_clear_interrupt(&avr_, &uart_.rxc);
  avr_regbit_clear(&avr_, uart_.rxc.raised);
}

void Usart0::write_data(std::uint8_t byte) {
  if (avr_regbit_get(&avr_, uart_.txen) == 0 || to_send_) {
    return;
  }
  if (!sending_) {
    sender_free_cycle_ = avr_.cycle;
    start_sending(byte);
    return;
  }
  to_send_ = byte;
  avr_clear_interrupt(&avr_, &uart_.udrc);
  avr_regbit_clear(&avr_, uart_.udrc.raised);
}

void Usart0::start_sending(std::uint8_t byte) {
  sending_ = true;
  sender_free_cycle_ += byte_cycles();
  queue_.at(sender_free_cycle_, [this, byte, reset = resets_] {
    if (reset == resets_) {
      end_sending(byte);
    }
  });
  avr_raise_interrupt(&avr_, &uart_.udrc);
}

void Usart0::end_sending(std::uint8_t byte) {
  sending_ = false;
  if (to_send_) {
    const std::uint8_t next = *to_send_;
    to_send_.reset();
    start_sending(next);
  } else {
    avr_raise_interrupt(&avr_, &uart_.txc);
  }
  if (on_sent) {
    on_sent(byte);
  }
}

}  // namespace echomap::emulator
