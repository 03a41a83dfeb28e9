// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <sys/types.h>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::rp2040 {

/// The orders of one message to the chip's program, or the events of its answer; README.md lists
/// both. All numbers are little endian.
class Message {
 public:
  Message() = default;
  explicit Message(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

  Message& byte(std::uint8_t value);
  Message& half_word(std::uint16_t value);
  Message& word(std::uint32_t value);
  Message& number(double value);
  Message& block(std::span<const std::uint8_t> values);

  /// Take from the front; throw std::runtime_error where the message is too short.
  std::uint8_t take_byte();
  std::uint32_t take_word();
  double take_number();
  std::vector<std::uint8_t> take_block();

  bool is_at_end() const { return at_ == bytes_.size(); }
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  void clear();

 private:
  template <typename T>
  Message& put(T value);
  template <typename T>
  T take();

  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// The program `node device.mjs` as a child, and the pipes to it.
class ChipLink {
 public:
  /// Starts it with this image. Throws std::system_error or std::runtime_error.
  explicit ChipLink(const std::filesystem::path& image);
  ~ChipLink();
  ChipLink(const ChipLink&) = delete;
  ChipLink& operator=(const ChipLink&) = delete;

  void send(const Message& message);
  /// Waits for the next message. Throws std::runtime_error where the child has ended.
  Message receive();

 private:
  void read_exactly(std::span<std::uint8_t> bytes);

  pid_t pid_ = -1;
  runner::Descriptor to_chip_;
  runner::Descriptor from_chip_;
};

}  // namespace echomap::rp2040
