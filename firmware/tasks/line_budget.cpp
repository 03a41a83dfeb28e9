// SPDX-License-Identifier: MIT
#include "firmware/tasks/line_budget.hpp"

#include "firmware/hal/uart.hpp"

namespace echomap {
namespace tasks {
namespace {

constexpr uint8_t kTelemetryPercent = 70;
constexpr uint8_t kAnswerPercent = 25;
constexpr uint16_t kMaxCredit = LineBudget::kMaxCreditBytes * 256U;

/// 1/256 bytes in a millisecond, which is also bytes in a window.
uint16_t share(uint8_t percent) {
  return static_cast<uint16_t>(hal::line_bytes_per_s() * (256UL * percent) / (100 * 1000UL));
}

}  // namespace

void LineBudget::tick() {
  const uint16_t earned = share(kTelemetryPercent);
  credit_ = credit_ < kMaxCredit - earned ? static_cast<uint16_t>(credit_ + earned) : kMaxCredit;
  if (++window_ms_ == 0) {
    end_window(earned);
  }
}

bool LineBudget::take(uint8_t bytes) {
  const uint16_t cost = static_cast<uint16_t>(bytes * 256U);
  if (credit_ < cost) {
    return false;
  }
  credit_ = static_cast<uint16_t>(credit_ - cost);
  used_bytes_ = static_cast<uint16_t>(used_bytes_ + bytes);
  return true;
}

bool LineBudget::take_answer(uint8_t bytes) {
  pay_answers(static_cast<uint8_t>(window_ms_ - paid_ms_));
  paid_ms_ = window_ms_;
  const uint16_t cost = static_cast<uint16_t>(bytes * 256U);
  if (answered_ > kMaxCredit - cost) {
    return false;
  }
  answered_ = static_cast<uint16_t>(answered_ + cost);
  return true;
}

void LineBudget::pay_answers(uint16_t ms) {
  const uint32_t paid = uint32_t{share(kAnswerPercent)} * ms;
  answered_ = answered_ > paid ? static_cast<uint16_t>(answered_ - paid) : uint16_t{0};
}

void LineBudget::end_window(uint16_t share_bytes) {
  pay_answers(static_cast<uint16_t>(256U - paid_ms_));
  paid_ms_ = 0;
  if (overloaded_ || used_bytes_ > share_bytes / 2) {
    quiet_windows_ = 0;
  } else if (++quiet_windows_ == kQuietWindows) {
    quiet_windows_ = 0;
    rate_step_ = static_cast<uint8_t>(rate_step_ - (rate_step_ != 0 ? 1 : 0));
  }
  if (overloaded_ && rate_step_ != kMaxRateStep) {
    ++rate_step_;
  }
  overloaded_ = false;
  used_bytes_ = 0;
}

}  // namespace tasks
}  // namespace echomap
