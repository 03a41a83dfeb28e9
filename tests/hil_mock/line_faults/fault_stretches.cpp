// SPDX-License-Identifier: MIT
#include "tests/hil_mock/line_faults/fault_stretches.hpp"

#include <array>
#include <cstring>
#include <vector>

#include "protocol/frame_encoder.hpp"
#include "protocol/link.hpp"
#include "protocol/messages.hpp"

namespace echomap::line_faults {
namespace {

using protocol::DecodeStatus;
using protocol::MessagesToHost;
using protocol::MessagesToRobot;

/// In a stretch the first two frames stay whole, a fault begins in the next four, and even a cut
/// leaves the last ones whole.
constexpr std::size_t kFrames = 16;
constexpr std::size_t kFirstHarmed = 2;
constexpr std::size_t kBehindHarmed = 6;

/// Fills fields with bytes of which a quarter are 0x00 and a quarter 0xFF, as robots send them.
class FillVisitor {
 public:
  explicit FillVisitor(world::NoiseStream& noise) : noise_(noise) {}
  template <class T>
  void operator()(const char* /*name*/, T& value) {
    std::array<std::uint8_t, sizeof(T)> bytes{};
    for (std::uint8_t& byte : bytes) {
      const double kind = noise_.uniform();
      byte = kind < 0.25 ? 0x00 : kind < 0.5 ? 0xFF : random_byte();
    }
    std::memcpy(&value, bytes.data(), sizeof(T));
  }

 private:
  std::uint8_t random_byte() { return static_cast<std::uint8_t>(noise_.uniform() * 256.0); }

  world::NoiseStream& noise_;
};

template <class M>
protocol::ByteSpan encode_random(protocol::FrameEncoder& encoder,
                                 std::uint8_t seq,
                                 world::NoiseStream& noise) {
  M message{};
  FillVisitor fill(noise);
  M::each(message, fill);
  return encoder.encode(message, seq);
}

using EncodeRandom = protocol::ByteSpan (*)(protocol::FrameEncoder&,
                                            std::uint8_t,
                                            world::NoiseStream&);

template <class List>
struct Encoders;
template <class... Messages>
struct Encoders<protocol::MessageList<Messages...>> {
  static std::vector<EncodeRandom> all() { return {encode_random<Messages>...}; }
};

/// A sender, a receiver and the line between them, in one direction.
class Stream {
 public:
  template <class List>
  Stream(List /*messages*/, world::NoiseStream& noise)
      : encoders_(Encoders<List>::all()), noise_(noise), decoder_(List::find_schema) {}

  void suffer(FaultKind kind, FaultOutcome& outcome) {
    send_stretch();
    apply_fault(kind, bytes_, place_of_fault(), noise_);
    const protocol::ReceiveCounters before = counters_;
    const std::uint64_t right = receive(outcome);
    ++outcome.faults;
    outcome.lost += kFrames - right;
    outcome.counted += static_cast<std::uint16_t>(counters_.frames_lost() - before.frames_lost());
    outcome.bad += static_cast<std::uint16_t>(counters_.frames_bad() - before.frames_bad());
  }

 private:
  using Bytes = std::vector<std::uint8_t>;

  void send_stretch() {
    bytes_.clear();
    ends_.clear();
    for (std::size_t i = 0; i < kFrames; ++i) {
      const auto pick =
          static_cast<std::size_t>(noise_.uniform() * static_cast<double>(encoders_.size()));
      const protocol::ByteSpan frame = encoders_[pick](encoder_, next_seq_++, noise_);
      bytes_.insert(bytes_.end(), frame.data, frame.data + frame.size);
      ends_.push_back(bytes_.size());
    }
    sent_ = bytes_;
  }

  std::size_t place_of_fault() {
    const std::size_t begin = ends_[kFirstHarmed - 1];
    const auto length = static_cast<double>(ends_[kBehindHarmed - 1] - begin);
    return begin + static_cast<std::size_t>(noise_.uniform() * length);
  }

  /// How many frames came out as they went in, in their order.
  std::uint64_t receive(FaultOutcome& outcome) {
    std::uint64_t right = 0;
    std::size_t next = 0;
    for (const std::uint8_t byte : bytes_) {
      const DecodeStatus status = decoder_.take(byte);
      const bool is_frame = status == DecodeStatus::kFrame;
      counters_.take(status, is_frame ? decoder_.frame().seq : std::uint8_t{0});
      if (!is_frame) {
        continue;
      }
      const std::size_t place = place_of(decoder_.frame());
      const bool is_right = place >= next && place < kFrames;
      next = is_right ? place + 1 : next;
      right += is_right ? 1 : 0;
      outcome.wrong += is_right ? 0 : 1;
    }
    return right;
  }

  /// Which sent frame this is; `kFrames` for none.
  std::size_t place_of(const protocol::Frame& frame) {
    const auto first_seq = static_cast<std::uint8_t>(next_seq_ - kFrames);
    const auto place = static_cast<std::uint8_t>(frame.seq - first_seq);
    return place < kFrames && content_of_sent(place) == content_of(frame) ? place : kFrames;
  }

  static Bytes content_of(const protocol::Frame& frame) {
    Bytes content{frame.id, frame.seq};
    content.insert(content.end(), frame.payload, frame.payload + frame.payload_size);
    return content;
  }

  Bytes content_of_sent(std::size_t place) {
    protocol::CobsDecoder cobs;
    Bytes content;
    for (std::size_t i = place == 0 ? 0 : ends_[place - 1]; i < ends_[place]; ++i) {
      std::uint8_t value = 0;
      if (cobs.take(sent_[i], value) == protocol::CobsStatus::kData) {
        content.push_back(value);
      }
    }
    content.resize(content.size() - 2);
    return content;
  }

  std::vector<EncodeRandom> encoders_;
  world::NoiseStream& noise_;
  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_;
  protocol::ReceiveCounters counters_;
  std::uint8_t next_seq_ = 0;
  Bytes bytes_;
  Bytes sent_;
  std::vector<std::size_t> ends_;
};

}  // namespace

FaultOutcome suffer_faults(FaultKind kind, int faults, std::uint32_t seed) {
  world::NoiseStream noise(seed + static_cast<std::uint32_t>(kind),
                           world::NoisePurpose::kLineFaults);
  Stream to_host(MessagesToHost{}, noise);
  Stream to_robot(MessagesToRobot{}, noise);
  FaultOutcome outcome;
  for (int i = 0; i < faults / 2; ++i) {
    to_host.suffer(kind, outcome);
    to_robot.suffer(kind, outcome);
  }
  return outcome;
}

}  // namespace echomap::line_faults
