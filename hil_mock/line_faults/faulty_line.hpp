// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hil_mock/line_faults/byte_faults.hpp"

namespace echomap::line_faults {

/// For a while nothing passes, as of a radio that is too far off.
struct Absence {
  double at_s = 0.0;
  double for_s = 0.0;
};

/// Everything that a line does to what passes, the same in both directions.
struct LineFaults {
  FaultRates rates;
  double loss = 0.0;  ///< Share of frames that are lost whole.
  std::vector<Absence> away{};
  std::uint32_t seed = 1;
};

/// Reads "flip=1e-4,drop=1e-4,insert=0,burst=0,cut=0,loss=0.01,away=60:5,seed=3", in any order;
/// what is not named is 0 or never, the seed 1; "away" is AT:FOR in simulated seconds and may be
/// named more than once. Throws std::invalid_argument with a sentence for the user.
LineFaults parse_line_faults(const std::string& text);

/// Whether nothing passes at this time.
bool is_away(const LineFaults& faults, double now_s);

/// The way that bytes go.
enum class Direction : std::uint8_t { kToRobot, kToHost };

/// One direction of a line with faults: loses frames, then harms bytes.
class FaultyLine {
 public:
  /// Directions of the same seed have different faults. Throws as ByteFaults and FrameLoss do.
  FaultyLine(const LineFaults& faults, Direction direction);

  std::vector<std::uint8_t> pass(std::span<const std::uint8_t> bytes) {
    return bytes_.pass(frames_.pass(bytes));
  }

 private:
  FrameLoss frames_;
  ByteFaults bytes_;
};

}  // namespace echomap::line_faults
