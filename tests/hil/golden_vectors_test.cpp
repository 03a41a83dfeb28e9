// SPDX-License-Identifier: MIT
/// Runs the golden vectors through the decoder and encoder of the boards' binaries.
#include "tests/support/golden_vectors.hpp"

#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

/// An image that sends every whole frame back, decoded into its message and encoded again.
class VectorEcho : public ::testing::TestWithParam<const char*> {
 protected:
  VectorEcho() {
    board.on_sent = [this](std::uint8_t byte) { sent.push_back(byte); };
    run_ms(5);
  }

  void run_ms(std::int64_t ms) { board.run_until(board.now_ns() + ms * 1'000'000); }

  std::vector<std::uint8_t> answer_to(const std::vector<std::uint8_t>& bytes) {
    sent.clear();
    board.receive(bytes);
    run_ms(15);  // 54 bytes there and back take 10 ms
    return sent;
  }

  const std::unique_ptr<EmulatedBoard> chip = make_emulated_board(release_image(GetParam()));
  runner::SimulatedBoard& board = chip->pins();
  std::vector<std::uint8_t> sent;
};

INSTANTIATE_TEST_SUITE_P(Boards, VectorEcho, ::testing::ValuesIn(vector_images()), image_label);

TEST_P(VectorEcho, EveryGoldenFrameComesBackToTheByte) {
  const GoldenVectors vectors = load_golden_vectors();
  ASSERT_GE(vectors.frames.size(), 40U);
  for (const GoldenFrame& frame : vectors.frames) {
    EXPECT_EQ(answer_to(frame.bytes), frame.bytes) << frame.message << ' ' << to_hex(frame.bytes);
  }
  std::printf("golden vectors: %zu frames through %s\n", vectors.frames.size(), GetParam());
}

TEST_P(VectorEcho, NoFrameWithOneWrongBitOfEverySeventhComesBack) {
  for (const GoldenFrame& frame : load_golden_vectors().frames) {
    for (std::size_t bit = 0; bit < 8 * (frame.bytes.size() - 1); bit += 7) {
      std::vector<std::uint8_t> damaged = frame.bytes;
      damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
      ASSERT_TRUE(answer_to(damaged).empty()) << frame.message << " bit " << bit;
    }
  }
}

}  // namespace
}  // namespace echomap::tests
