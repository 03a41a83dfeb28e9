// SPDX-License-Identifier: MIT
#include "host/session/pace.hpp"

#include <array>
#include <chrono>

namespace echomap::session {
namespace {

using std::chrono::milliseconds;
using time::HostTime;

constexpr milliseconds kStep(5);
constexpr std::size_t kBufferSize = 4096;
/// Real time for bytes that the device says it has written.
constexpr std::chrono::seconds kBytesPatience(10);

class RealTimePace final : public Pace {
 public:
  HostTime step(transport::ByteStream& stream,
                std::uint64_t /*bytes_sent*/,
                const Receive& receive) override {
    std::array<std::uint8_t, kBufferSize> buffer{};
    const std::size_t count = stream.read_some(buffer, kStep);
    receive(std::span(buffer).first(count));
    return HostTime(std::chrono::duration_cast<time::HostClock::duration>(
        std::chrono::steady_clock::now() - start_));
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class LockstepPace final : public Pace {
 public:
  explicit LockstepPace(transport::LockstepChannel& channel) : channel_(channel) {}

  HostTime step(transport::ByteStream& stream,
                std::uint64_t bytes_sent,
                const Receive& receive) override {
    const HostTime target = now_ + kStep;
    const auto reached = channel_.grant(target.time_since_epoch().count(), bytes_sent);
    if (reached) {
      now_ = target;
      read_all(stream, reached->device_bytes, receive);
    }
    return now_;
  }

  std::string end_reason() const override {
    return bytes_are_missing_ ? "bytes that the device sent did not arrive"
                              : channel_.close_reason();
  }

 private:
  void read_all(transport::ByteStream& stream, std::uint64_t device_bytes, const Receive& receive) {
    std::array<std::uint8_t, kBufferSize> buffer{};
    while (bytes_received_ < device_bytes && stream.status() == transport::StreamStatus::kOpen) {
      const std::size_t count = stream.read_some(buffer, kBytesPatience);
      if (count == 0) {
        bytes_are_missing_ = stream.status() == transport::StreamStatus::kOpen;
        return;
      }
      bytes_received_ += count;
      receive(std::span(buffer).first(count));
    }
  }

  transport::LockstepChannel& channel_;
  HostTime now_;
  std::uint64_t bytes_received_ = 0;
  bool bytes_are_missing_ = false;
};

}  // namespace

std::unique_ptr<Pace> real_time_pace() { return std::make_unique<RealTimePace>(); }

std::unique_ptr<Pace> lockstep_pace(transport::LockstepChannel& channel) {
  return std::make_unique<LockstepPace>(channel);
}

}  // namespace echomap::session
