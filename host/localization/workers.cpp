// SPDX-License-Identifier: MIT
#include "host/localization/workers.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::localization {

namespace {

/// Looks out for what another thread is about to change: closely at first, then letting others run.
class Lookout {
 public:
  /// It has taken long: better to sleep.
  bool is_over() const { return looks_ >= kClosely; }
  void look() {
    if (++looks_ > kClosely) {
      std::this_thread::yield();
      return;
    }
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }

 private:
  static constexpr int kClosely = 2000;
  int looks_ = 0;
};

}  // namespace

/// Numbers are claimed from a ticket that counts down, so that a thread that comes late finds
/// nothing left and keeps nobody waiting. The ticket's upper half numbers the job, so that a claim
/// never falls into the next one.
struct Workers::Crew {
  explicit Crew(int helpers) {
    for (int i = 0; i < helpers; ++i) {
      threads.emplace_back([this](const std::stop_token& over) { help(over); });
    }
  }

  static std::uint32_t left_in(std::uint64_t value) { return static_cast<std::uint32_t>(value); }

  void start(std::uint32_t count, Job new_job) {
    job = new_job;
    unfinished.store(count, std::memory_order_relaxed);
    const std::uint64_t next = (ticket.load(std::memory_order_relaxed) >> 32U) + 1;
    ticket.store(next << 32U | count);
    // Who is about to sleep has said so before it looks at the ticket for the last time.
    if (sleepers.load() > 0) {
      const std::lock_guard lock(mutex);
      wake.notify_all();
    }
  }

  /// Does one number of the job, where any is left.
  bool do_one() {
    std::uint64_t seen = ticket.load(std::memory_order_acquire);
    while (left_in(seen) > 0) {
      if (ticket.compare_exchange_weak(
              seen, seen - 1, std::memory_order_acquire, std::memory_order_acquire)) {
        job.call(job.task, left_in(seen) - 1);
        unfinished.fetch_sub(1, std::memory_order_release);
        return true;
      }
    }
    return false;
  }

  /// Jobs come one soon after the other: a thread looks out for the next a while before it sleeps.
  void help(const std::stop_token& over) {
    Lookout lookout;
    while (!over.stop_requested()) {
      if (do_one()) {
        lookout = {};
      } else if (!lookout.is_over()) {
        lookout.look();
      } else {
        std::unique_lock lock(mutex);
        ++sleepers;
        wake.wait(lock, over, [this] { return left_in(ticket.load()) > 0; });
        --sleepers;
        lookout = {};
      }
    }
  }

  std::mutex turn;  ///< Of those who share out work.
  Job job;
  std::atomic<std::uint64_t> ticket = 0;
  std::atomic<std::uint32_t> unfinished = 0;
  std::atomic<int> sleepers = 0;
  std::mutex mutex;
  std::condition_variable_any wake;
  std::vector<std::jthread> threads;  ///< The first to go: they use the rest.
};

Workers::Workers(int threads) : threads_(threads) {
  geometry::ParameterValidator("workers").at_least("threads", threads, 1);
  if (threads > 1) {
    crew_ = std::make_shared<Crew>(threads - 1);
  }
}

void Workers::run(std::size_t count, Job job) const {
  const std::lock_guard turn(crew_->turn);
  crew_->start(static_cast<std::uint32_t>(count), job);
  while (crew_->do_one()) {
  }
  for (Lookout lookout; crew_->unfinished.load(std::memory_order_acquire) > 0;) {
    lookout.look();
  }
}

}  // namespace echomap::localization
