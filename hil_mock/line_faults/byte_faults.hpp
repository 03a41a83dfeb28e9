// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hil_mock/world/noise.hpp"

namespace echomap::line_faults {

/// What may happen to bytes on a line.
enum class FaultKind : std::uint8_t {
  kFlip,    ///< One bit of a byte is wrong: noise.
  kDrop,    ///< A byte is missing: an overrun.
  kInsert,  ///< A random byte comes before another: a false start bit.
  kBurst,   ///< `kBurstBytes` bytes are random: a motor starts.
  kCut,     ///< `kCutBytes` bytes are missing: a full buffer.
};
constexpr std::size_t kFaultKinds = 5;
constexpr std::size_t kBurstBytes = 12;
constexpr std::size_t kCutBytes = 40;

/// Does one fault to a whole stream, beginning at byte `at`; what reaches beyond the end is
/// nothing.
void apply_fault(FaultKind kind,
                 std::vector<std::uint8_t>& bytes,
                 std::size_t at,
                 world::NoiseStream& noise);

/// How often a fault begins at a byte, each 0 .. 1; their sum is at most 1.
struct FaultRates {
  double flip = 0.0;
  double drop = 0.0;
  double insert = 0.0;
  double burst = 0.0;
  double cut = 0.0;
};

/// Seeded faults on a stream that comes in pieces of any size: the pieces do not matter.
class ByteFaults {
 public:
  /// Throws std::invalid_argument where a rate or their sum is not in 0 .. 1.
  ByteFaults(const FaultRates& rates, world::NoiseStream noise);

  /// What is left of `bytes`, after faults that have begun in earlier ones too.
  std::vector<std::uint8_t> pass(std::span<const std::uint8_t> bytes);

  std::uint64_t faults() const { return faults_; }

 private:
  void pass_byte(std::uint8_t byte, std::vector<std::uint8_t>& passed);

  FaultRates rates_;
  world::NoiseStream noise_;
  std::size_t burst_left_ = 0;
  std::size_t cut_left_ = 0;
  std::uint64_t faults_ = 0;
};

/// Loses whole frames of a stream, told apart by the zero that ends each, with a probability of 0
/// .. 1.
class FrameLoss {
 public:
  /// Throws std::invalid_argument for another probability.
  FrameLoss(double probability, world::NoiseStream noise);

  std::vector<std::uint8_t> pass(std::span<const std::uint8_t> bytes);

  std::uint64_t frames_lost() const { return frames_lost_; }

 private:
  double probability_;
  world::NoiseStream noise_;
  bool in_frame_ = false;
  bool loses_frame_ = false;
  std::uint64_t frames_lost_ = 0;
};

}  // namespace echomap::line_faults
