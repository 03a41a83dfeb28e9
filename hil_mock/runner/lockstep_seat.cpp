// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_seat.hpp"

#include <chrono>
#include <vector>

#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {
namespace {

/// Longest wait before the next look at the stop signal.
constexpr std::chrono::milliseconds kLook{100};
/// The host's bytes have been written before its grant; if they do not come, they are lost.
constexpr std::chrono::seconds kBytesPatience{5};

}  // namespace

bool LockstepSeat::accept(const Grant& grant) {
  if (!wait_for_bytes(grant.host_bytes)) {
    return false;
  }
  std::vector<std::uint8_t> bytes;
  for (; handed_bytes_ < grant.host_bytes; ++handed_bytes_) {
    bytes.push_back(waiting_.front());
    waiting_.pop_front();
  }
  if (!bytes.empty()) {
    simulation_->receive(bytes);
  }
  grant_ = grant;
  return true;
}

std::optional<std::int64_t> LockstepSeat::granted_ns() const {
  return grant_ ? std::optional(grant_->until_us * 1000) : std::nullopt;
}

void LockstepSeat::answer() {
  if (!grant_) {
    return;
  }
  const std::vector<std::uint8_t> sent = simulation_->take_sent();
  device_bytes_ += sent.size();
  endpoint_->send(sent);
  server_->send_reached(
      grant_->until_us,
      device_bytes_,
      tells_truth_ ? std::optional(simulation_->world().T_start_robot()) : std::nullopt);
  grant_.reset();
}

void LockstepSeat::collect_bytes() {
  const std::vector<std::uint8_t> bytes = endpoint_->receive();
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  endpoint_->send({});
}

bool LockstepSeat::wait_for_bytes(std::uint64_t host_bytes) {
  const auto end = std::chrono::steady_clock::now() + kBytesPatience;
  collect_bytes();
  while (handed_bytes_ + waiting_.size() < host_bytes) {
    if (stop_requested() || std::chrono::steady_clock::now() > end) {
      return false;
    }
    wait_readable(*endpoint_, -1, kLook);
    collect_bytes();
  }
  return true;
}

}  // namespace echomap::runner
