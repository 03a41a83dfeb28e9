// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// A ByteStream that outlives its cable: when the one below closes it is opened again, every
/// `kRetryPeriod`, until it is back. In between the status is kAway and bytes are dropped; how long
/// that may last is for the user of the stream to say.
class ReconnectingStream final : public ByteStream {
 public:
  static constexpr std::chrono::milliseconds kRetryPeriod{200};
  /// Throws TransportError while there is nothing to open.
  using Open = std::function<std::unique_ptr<ByteStream>()>;

  /// `first` is open; `open` opens it again.
  ReconnectingStream(std::unique_ptr<ByteStream> first, Open open);

  std::size_t read_some(std::span<std::uint8_t> into, std::chrono::microseconds wait) override;
  void write(std::span<const std::uint8_t> bytes) override;
  StreamStatus status() const override {
    return below_ ? StreamStatus::kOpen : StreamStatus::kAway;
  }
  std::string close_reason() const override { return reason_; }
  std::string name() const override { return name_; }
  std::uint64_t reconnects() const override { return reconnects_; }

 private:
  void look_below();
  void try_to_open();

  Open open_;
  std::unique_ptr<ByteStream> below_;  ///< Null while away.
  std::string name_;
  std::string reason_;
  std::chrono::steady_clock::time_point next_try_;
  std::uint64_t reconnects_ = 0;
};

}  // namespace echomap::transport
