// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/byte_faults.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::line_faults {
namespace {

using Bytes = std::vector<std::uint8_t>;

world::NoiseStream fault_noise(std::uint32_t seed) {
  return {seed, world::NoisePurpose::kLineFaults};
}

Bytes counting(std::size_t size) {
  Bytes bytes(size);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

Bytes after(FaultKind kind, std::size_t at) {
  Bytes bytes = counting(100);
  auto stream = fault_noise(1);
  apply_fault(kind, bytes, at, stream);
  return bytes;
}

TEST(ApplyFault, FlipsOneBit) {
  const Bytes bytes = after(FaultKind::kFlip, 50);
  EXPECT_EQ(std::popcount(static_cast<unsigned>(bytes[50] ^ 50)), 1);
  EXPECT_EQ(bytes.size(), 100U);
}

TEST(ApplyFault, DropsInsertsAndCuts) {
  EXPECT_EQ(after(FaultKind::kDrop, 50)[50], 51);
  const Bytes longer = after(FaultKind::kInsert, 50);
  EXPECT_EQ(longer.size(), 101U);
  EXPECT_EQ(longer[51], 50);
  const Bytes shorter = after(FaultKind::kCut, 50);
  EXPECT_EQ(shorter.size(), 60U);
  EXPECT_EQ(shorter[50], 90);
  EXPECT_EQ(after(FaultKind::kCut, 80).size(), 80U);
}

TEST(ApplyFault, OverwritesTwelveBytes) {
  const Bytes before = counting(100);
  const Bytes bytes = after(FaultKind::kBurst, 50);
  EXPECT_TRUE(std::equal(before.begin(), before.begin() + 50, bytes.begin()));
  EXPECT_FALSE(std::equal(before.begin() + 50, before.begin() + 62, bytes.begin() + 50));
  EXPECT_TRUE(std::equal(before.begin() + 62, before.end(), bytes.begin() + 62));
}

TEST(ByteFaults, ComeAsOftenAsTheySay) {
  ByteFaults faults({.flip = 1e-3, .drop = 1e-3, .insert = 2e-3, .burst = 1e-4, .cut = 1e-4},
                    fault_noise(2));
  const Bytes bytes = counting(1'000'000);
  const Bytes passed = faults.pass(bytes);
  EXPECT_NEAR(static_cast<double>(faults.faults()), 4200.0, 250.0);
  // 1000 dropped, 2000 inserted, 100 times 40 cut.
  EXPECT_NEAR(static_cast<double>(passed.size()), 997'000.0, 1500.0);
}

TEST(ByteFaults, DoNotDependOnThePieces) {
  const FaultRates rates{0.01, 0.01, 0.01, 0.01, 0.01};
  ByteFaults whole(rates, fault_noise(3));
  ByteFaults pieces(rates, fault_noise(3));
  const Bytes bytes = counting(1000);
  Bytes passed;
  for (const std::uint8_t byte : bytes) {
    const Bytes piece = pieces.pass({&byte, 1});
    passed.insert(passed.end(), piece.begin(), piece.end());
  }
  EXPECT_EQ(passed, whole.pass(bytes));
}

TEST(ByteFaults, RefuseRatesThatAreNone) {
  EXPECT_THROW(ByteFaults({.flip = -0.1}, fault_noise(1)), std::invalid_argument);
  EXPECT_THROW(ByteFaults({.flip = 0.6, .cut = 0.6}, fault_noise(1)), std::invalid_argument);
  EXPECT_THROW(FrameLoss(1.5, fault_noise(1)), std::invalid_argument);
}

TEST(FrameLoss, LosesWholeFrames) {
  Bytes stream;
  for (int i = 0; i < 20'000; ++i) {
    stream.insert(stream.end(), {4, 1, 2, 3, 0});
  }
  FrameLoss loss(0.05, fault_noise(4));
  const Bytes passed = loss.pass(stream);
  EXPECT_NEAR(static_cast<double>(loss.frames_lost()), 1000.0, 100.0);
  EXPECT_EQ(passed.size(), stream.size() - 5 * loss.frames_lost());
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(passed, 0)) * 5, passed.size());
}

TEST(FrameLoss, LeavesDelimitersAlone) {
  FrameLoss loss(1.0, fault_noise(5));
  EXPECT_EQ(loss.pass(Bytes{0, 2, 1, 0, 0}), (Bytes{0, 0}));
}

}  // namespace
}  // namespace echomap::line_faults
