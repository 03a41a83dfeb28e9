// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "host/localization/particles.hpp"

namespace echomap::localization {

/// Threads that share out work. They sleep while there is none; copies stand for the same threads.
class Workers {
 public:
  /// So many threads, the caller's among them: 1 starts none. Throws std::invalid_argument for
  /// fewer.
  explicit Workers(int threads = 1);

  int threads() const { return threads_; }

  /// Calls task(number) once for each number below `count`, at most 2^32 - 1, side by side in any
  /// order, and returns when all are done. A task neither throws nor shares out work itself;
  /// callers take turns.
  template <typename Task>
  void share(std::size_t count, const Task& task) const {
    if (!crew_ || count < 2) {
      for (std::size_t number = 0; number < count; ++number) {
        task(number);
      }
      return;
    }
    run(count, {&task, [](const void* self, std::size_t number) {
                  (*static_cast<const Task*>(self))(number);
                }});
  }

 private:
  struct Crew;
  struct Job {
    const void* task = nullptr;
    void (*call)(const void* task, std::size_t number) = nullptr;
  };

  void run(std::size_t count, Job job) const;

  int threads_;
  std::shared_ptr<Crew> crew_;  ///< Null for one thread.
};

/// Particles are shared out in blocks of that many, and sums are those of blocks, added in their
/// order: whatever the number of threads, results are the same to the bit.
inline constexpr std::size_t kBlock = 512;

/// The last of them may hold fewer.
constexpr std::size_t blocks_in(std::size_t particles) { return (particles + kBlock - 1) / kBlock; }

/// Calls task(range, number) for each block of so many particles.
template <typename Task>
void share_blocks(const Workers& workers, std::size_t particles, const Task& task) {
  workers.share(blocks_in(particles), [&](std::size_t number) {
    const std::size_t begin = number * kBlock;
    task(ParticleRange{begin, std::min(begin + kBlock, particles)}, number);
  });
}

}  // namespace echomap::localization
