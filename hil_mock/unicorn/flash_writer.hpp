// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// The flash interface and the last 4 of 32 kB of flash, which the program may write by half-words
/// and erase by pages of 1 kB; what stands there outlives every reset. The core waits meanwhile.
/// Source: ST PM0075, and the data sheet's table 32 for the times.
class FlashWriter final : public Peripheral {
 public:
  static constexpr std::uint32_t kFlashAddress = 0x08000000;
  static constexpr std::uint32_t kDataBytes = 0x1000;
  /// Where the memory that it writes begins.
  static constexpr std::uint32_t kDataAddress = kFlashAddress + 0x8000 - kDataBytes;

  explicit FlashWriter(EventQueue& queue) : queue_(queue) { data_.fill(kErased); }

  /// The memory itself, at an offset from kDataAddress.
  std::uint32_t read_data(std::uint32_t offset, unsigned size) const;
  void write_data(std::uint32_t offset, unsigned size, std::uint32_t value);

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  static constexpr std::uint16_t kErased = 0xFFFF;

  void take_key(std::uint32_t key);
  void erase_page();

  EventQueue& queue_;
  std::array<std::uint16_t, kDataBytes / 2> data_{};
  std::uint32_t acr_ = 0;
  std::uint32_t sr_ = 0;
  std::uint32_t cr_ = 0;
  std::uint32_t ar_ = 0;
  bool first_key_ = false;
};

}  // namespace echomap::unicorn
