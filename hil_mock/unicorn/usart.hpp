// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// USART1 and its two wires, 8N1: one byte waits while another is sent; one received byte waits
/// while another arrives, which is lost with an overrun where nobody has read the first. Source: ST
/// RM0008, chapter 27.
class Usart final : public Peripheral {
 public:
  Usart(EventQueue& queue, Nvic& nvic) : queue_(queue), nvic_(nvic) {}

  /// Puts bytes on the receive wire at the pace of the baud rate, behind those under way.
  void receive(std::span<const std::uint8_t> bytes);
  /// Called with each byte sent, when its stop bit is over.
  std::function<void(std::uint8_t)> on_sent;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  /// A byte half sent and one not read are lost, the receive wire goes on.
  void reset() override;

 private:
  std::uint64_t byte_cycles() const;
  bool receives() const;
  void start_next_received();
  void take_received();
  void start_sending(std::uint8_t byte);
  void end_sending(std::uint8_t byte);
  void update();

  EventQueue& queue_;
  Nvic& nvic_;
  std::uint32_t sr_ = 0;
  std::uint32_t brr_ = 0;
  std::uint32_t cr1_ = 0;
  std::uint8_t received_ = 0;
  bool overrun_was_read_ = false;
  std::deque<std::uint8_t> on_wire_;
  std::uint64_t wire_free_cycle_ = 0;
  bool sending_ = false;
  std::optional<std::uint8_t> to_send_;
  std::uint64_t sender_free_cycle_ = 0;
  std::uint32_t resets_ = 0;
};

}  // namespace echomap::unicorn
