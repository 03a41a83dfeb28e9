// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <avr_uart.h>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <sim_avr.h>
#include <span>

#include "hil_mock/emulator/cycle_queue.hpp"
#include "hil_mock/emulator/register_hooks.hpp"

namespace echomap::emulator {

/// The data register and the two wires of USART0, 8N1, in place of simavr's: that one takes 11 bits
/// for a byte, sends with a gap after each, holds 63 received bytes and never overruns. Ours has
/// silicon's depth: one byte waiting to be sent; two received and a third in the shift register,
/// then bytes are dropped and DOR0 is set. simavr keeps the control registers and interrupts.
class Usart0 {
 public:
  Usart0(avr_t& avr, RegisterHooks& hooks, CycleQueue& queue);

  /// Puts bytes on the receive wire at the pace of the baud rate, behind those under way.
  void receive(std::span<const std::uint8_t> bytes);
  /// Called with each byte sent, when its stop bit is over.
  std::function<void(std::uint8_t)> on_sent;

  /// The chip was reset: a byte half sent and bytes not read are lost, the receive wire goes on.
  void reset();

 private:
  std::uint64_t byte_cycles() const;
  bool receiver_enabled() const;
  void start_next_received();
  void take_received();
  std::uint8_t read_data();
  void drop_unread();
  void write_data(std::uint8_t byte);
  void start_sending(std::uint8_t byte);
  void end_sending(std::uint8_t byte);

  avr_t& avr_;
  avr_uart_t& uart_;
  CycleQueue& queue_;
  std::deque<std::uint8_t> on_wire_;
  std::uint64_t wire_free_cycle_ = 0;
  std::deque<std::uint8_t> unread_;
  bool sending_ = false;
  std::optional<std::uint8_t> to_send_;
  std::uint64_t sender_free_cycle_ = 0;
  std::uint32_t resets_ = 0;
};

}  // namespace echomap::emulator
