// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace echomap::live_page {

/// Which client drives the robot: one at a time. Times are of the server's clock.
class DriverLock {
 public:
  /// Of silence, after which the lock is free.
  static constexpr double kSilenceMs = 2000.0;

  /// What became of a wish to steer.
  enum class Steering : unsigned char {
    kAllowed,
    kHeldByOther,
    kMustLetGo,  ///< The robot was stopped meanwhile: the stick has to come back to rest first.
  };

  /// Takes the lock where it is free. `is_at_rest`: the stick is at zero.
  Steering steer(std::uint64_t client, bool is_at_rest, double now_ms);
  /// The robot is stopped: the one that steers has to let go before it steers again.
  void stop();
  /// Whether the client held the lock, which is free now.
  bool release(std::uint64_t client, double now_ms);

  std::optional<std::uint64_t> holder(double now_ms) const;
  bool is_held_by_other(std::uint64_t client, double now_ms) const;

 private:
  std::optional<std::uint64_t> holder_;
  double last_steered_ms_ = 0.0;
  bool must_let_go_ = false;
};

}  // namespace echomap::live_page
