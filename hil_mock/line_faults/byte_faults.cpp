// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/byte_faults.hpp"

#include <algorithm>
#include <stdexcept>

namespace echomap::line_faults {
namespace {

std::uint8_t random_byte(world::NoiseStream& noise) {
  return static_cast<std::uint8_t>(noise.uniform() * 256.0);
}

std::uint8_t with_flipped_bit(std::uint8_t byte, world::NoiseStream& noise) {
  const auto bit = static_cast<unsigned>(noise.uniform() * 8.0);
  return static_cast<std::uint8_t>(byte ^ (1U << bit));
}

bool is_share(double value) { return value >= 0.0 && value <= 1.0; }

FaultRates validated(const FaultRates& rates) {
  const double sum = rates.flip + rates.drop + rates.insert + rates.burst + rates.cut;
  const bool holds = is_share(rates.flip) && is_share(rates.drop) && is_share(rates.insert) &&
                     is_share(rates.burst) && is_share(rates.cut) && is_share(sum);
  if (!holds) {
    throw std::invalid_argument("line faults: each rate and their sum must be in 0 .. 1");
  }
  return rates;
}

}  // namespace

void apply_fault(FaultKind kind,
                 std::vector<std::uint8_t>& bytes,
                 std::size_t at,
                 world::NoiseStream& noise) {
  const auto place = [&](std::size_t index) {
    return bytes.begin() + static_cast<std::ptrdiff_t>(std::min(index, bytes.size()));
  };
  switch (kind) {
    case FaultKind::kFlip:
      bytes[at] = with_flipped_bit(bytes[at], noise);
      break;
    case FaultKind::kDrop:
      bytes.erase(place(at));
      break;
    case FaultKind::kInsert:
      bytes.insert(place(at), random_byte(noise));
      break;
    case FaultKind::kBurst:
      std::generate(place(at), place(at + kBurstBytes), [&] { return random_byte(noise); });
      break;
    case FaultKind::kCut:
      bytes.erase(place(at), place(at + kCutBytes));
      break;
  }
}

ByteFaults::ByteFaults(const FaultRates& rates, world::NoiseStream noise)
    : rates_(validated(rates)), noise_(noise) {}

std::vector<std::uint8_t> ByteFaults::pass(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> passed;
  for (const std::uint8_t byte : bytes) {
    pass_byte(byte, passed);
  }
  return passed;
}

void ByteFaults::pass_byte(std::uint8_t byte, std::vector<std::uint8_t>& passed) {
  if (cut_left_ > 0) {
    --cut_left_;
    return;
  }
  if (burst_left_ > 0) {
    --burst_left_;
    passed.push_back(random_byte(noise_));
    return;
  }
  double fate = noise_.uniform();
  const auto falls_on = [&fate](double rate) { return (fate -= rate) < 0.0; };
  ++faults_;
  if (falls_on(rates_.flip)) {
    passed.push_back(with_flipped_bit(byte, noise_));
  } else if (falls_on(rates_.drop)) {
    return;
  } else if (falls_on(rates_.insert)) {
    passed.insert(passed.end(), {random_byte(noise_), byte});
  } else if (falls_on(rates_.burst)) {
    burst_left_ = kBurstBytes - 1;
    passed.push_back(random_byte(noise_));
  } else if (falls_on(rates_.cut)) {
    cut_left_ = kCutBytes - 1;
  } else {
    --faults_;
    passed.push_back(byte);
  }
}

FrameLoss::FrameLoss(double probability, world::NoiseStream noise)
    : probability_(probability), noise_(noise) {
  if (!is_share(probability)) {
    throw std::invalid_argument("line faults: the loss of frames must be in 0 .. 1");
  }
}

std::vector<std::uint8_t> FrameLoss::pass(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> passed;
  for (const std::uint8_t byte : bytes) {
    if (!in_frame_) {
      // A zero on its own is no frame: it may end what came before.
      loses_frame_ = byte != 0 && noise_.uniform() < probability_;
      frames_lost_ += loses_frame_ ? 1 : 0;
    }
    in_frame_ = byte != 0;
    if (!loses_frame_) {
      passed.push_back(byte);
    }
  }
  return passed;
}

}  // namespace echomap::line_faults
