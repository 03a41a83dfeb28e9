// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace echomap::robot_link {

/// How often a frame suffers what, each 0 .. 1; faults come one at a time.
struct LineFaults {
  double lost = 0.0;
  double damaged = 0.0;  ///< One bit of it flips.
  double duplicated = 0.0;
};

/// One direction of a cable: delays bytes by whole milliseconds and harms whole frames, told apart
/// by their delimiters.
class SimulatedLine {
 public:
  using Bytes = std::vector<std::uint8_t>;

  SimulatedLine(int delay_ms, std::mt19937& random) : delay_ms_(delay_ms), random_(random) {}

  void put(const Bytes& bytes, int now_ms);
  /// What has arrived by `now_ms`.
  Bytes take(int now_ms);

  LineFaults faults;
  bool is_cut = false;
  int frames_harmed = 0;

 private:
  void put_frame(int now_ms);
  double roll() { return static_cast<double>(random_()) / 4294967296.0; }

  struct Arrival {
    int at_ms;
    Bytes bytes;
  };
  int delay_ms_;
  std::mt19937& random_;
  Bytes frame_;
  std::deque<Arrival> under_way_;
};

inline void SimulatedLine::put(const Bytes& bytes, int now_ms) {
  for (const std::uint8_t byte : bytes) {
    frame_.push_back(byte);
    if (byte == 0) {
      put_frame(now_ms);
      frame_.clear();
    }
  }
}

inline void SimulatedLine::put_frame(int now_ms) {
  if (is_cut) {
    return;
  }
  double fate = frame_.size() > 1 ? roll() : 1.0;
  const auto falls_on = [&fate](double share) { return (fate -= share) < 0.0; };
  if (falls_on(faults.lost)) {
    ++frames_harmed;
    return;
  }
  if (falls_on(faults.damaged)) {
    ++frames_harmed;
    frame_[random_() % (frame_.size() - 1)] ^= static_cast<std::uint8_t>(1U << (random_() % 8));
  } else if (falls_on(faults.duplicated)) {
    under_way_.push_back({now_ms + delay_ms_, frame_});
  }
  under_way_.push_back({now_ms + delay_ms_, frame_});
}

inline SimulatedLine::Bytes SimulatedLine::take(int now_ms) {
  Bytes arrived;
  for (; !under_way_.empty() && under_way_.front().at_ms <= now_ms; under_way_.pop_front()) {
    const Bytes& bytes = under_way_.front().bytes;
    arrived.insert(arrived.end(), bytes.begin(), bytes.end());
  }
  return arrived;
}

}  // namespace echomap::robot_link
