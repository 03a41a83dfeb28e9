// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hil_mock/line_faults/byte_faults.hpp"

namespace echomap::line_faults {

/// What came of the faults of one kind.
struct FaultOutcome {
  std::uint64_t faults = 0;
  std::uint64_t lost = 0;     ///< Frames that did not come out as they went in.
  std::uint64_t wrong = 0;    ///< Frames that came out and never went in.
  std::uint64_t counted = 0;  ///< Lost frames by ReceiveCounters.
  std::uint64_t bad = 0;      ///< Frames that failed a check, by ReceiveCounters.

  double lost_per_fault() const { return static_cast<double>(lost) / static_cast<double>(faults); }
};

/// Does so many faults of one kind, one at a time, to streams of every message, half of them in
/// each direction.
FaultOutcome suffer_faults(FaultKind kind, int faults, std::uint32_t seed);

}  // namespace echomap::line_faults
