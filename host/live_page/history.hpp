// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "host/live_page/message.hpp"

namespace echomap::live_page {

/// The messages of one run, in the order of their time, and the newest of each. One thread adds,
/// others read: every call is safe beside the others.
class History {
 public:
  /// Called after each message, by the thread that adds it; it must not wait. Null for nobody.
  using Listener = std::function<void(const SharedMessage&)>;

  /// Passes the message to the listener, and keeps it: motions and particles thinned, up to
  /// `kMaxBytes` in all; from then on only events and new maps are kept.
  void add(const SharedMessage& message);
  void listen(Listener listener);

  /// What a client that connects has to know: hello, tiles, trail, room, particles, state, motion.
  std::vector<SharedMessage> newest() const;
  /// All that was kept, from that one on.
  std::vector<SharedMessage> since(std::size_t first) const;

  static constexpr std::size_t kMaxBytes = std::size_t{192} << 20;

 private:
  bool is_kept(const Message& message);

  mutable std::mutex mutex_;
  Listener listener_;
  std::vector<SharedMessage> kept_;
  std::size_t kept_bytes_ = 0;
  double next_motion_s_ = 0.0;  ///< Of the run: from when on one is kept again.
  double next_particles_s_ = 0.0;
  std::map<std::pair<MessageKind, std::uint64_t>, SharedMessage> newest_;
};

}  // namespace echomap::live_page
