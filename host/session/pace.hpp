// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "host/time/host_time.hpp"
#include "host/transport/byte_stream.hpp"
#include "host/transport/lockstep_channel.hpp"

namespace echomap::session {

/// How a session's time passes: each step waits for a short while, or for the first bytes, and
/// hands over what has come.
class Pace {
 public:
  using Receive = std::function<void(std::span<const std::uint8_t>)>;

  virtual ~Pace() = default;
  /// Lets a short step of time pass and answers the instant at its end. `bytes_sent` have been
  /// written to the stream in all.
  virtual time::HostTime step(transport::ByteStream& stream,
                              std::uint64_t bytes_sent,
                              const Receive& receive) = 0;
  /// Why no more time can pass; empty while it does.
  virtual std::string end_reason() const { return {}; }
};

/// A robot on a desk: the steady clock.
std::unique_ptr<Pace> real_time_pace();

/// A simulated robot: time is granted in steps of 5 ms (docs/guides/lockstep.md). Keeps a reference
/// to the channel.
std::unique_ptr<Pace> lockstep_pace(transport::LockstepChannel& channel);

}  // namespace echomap::session
