// SPDX-License-Identifier: MIT
#include "host/session/time_scale.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace echomap::session {
namespace {

using WallClock = std::chrono::steady_clock;

/// Waits below this are put together: a thread that sleeps wakes late.
constexpr std::chrono::milliseconds kShortestSleep(2);

class ScaledPace final : public Pace {
 public:
  ScaledPace(std::unique_ptr<Pace> pace, const TimeScale& scale)
      : pace_(std::move(pace)), scale_(scale) {}

  time::HostTime step(transport::ByteStream& stream,
                      std::uint64_t bytes_sent,
                      const Receive& receive) override {
    const time::HostTime now = pace_->step(stream, bytes_sent, receive);
    if (const double factor = scale_.now(); factor > 0.0) {
      wait(std::chrono::duration<double>(now - last_) / factor);
    }
    last_ = now;
    return now;
  }

  std::string end_reason() const override { return pace_->end_reason(); }

 private:
  void wait(std::chrono::duration<double> passed) {
    due_ = std::max(due_ + std::chrono::duration_cast<WallClock::duration>(passed),
                    WallClock::now() - kShortestSleep);
    if (due_ - WallClock::now() >= kShortestSleep) {
      std::this_thread::sleep_until(due_);
    }
  }

  std::unique_ptr<Pace> pace_;
  const TimeScale& scale_;
  time::HostTime last_;
  WallClock::time_point due_ = WallClock::now();
};

}  // namespace

std::unique_ptr<Pace> scaled_pace(std::unique_ptr<Pace> pace, const TimeScale& scale) {
  return std::make_unique<ScaledPace>(std::move(pace), scale);
}

}  // namespace echomap::session
