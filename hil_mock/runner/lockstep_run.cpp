// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_run.hpp"

#include <chrono>
#include <stdexcept>
#include <variant>

#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {
namespace {

/// Longest wait before the next look at the stop signal.
constexpr std::chrono::milliseconds kPatience{100};
/// The host's bytes have been written before its grant; if they do not come, they are lost.
constexpr std::chrono::seconds kBytesPatience{5};
constexpr std::int64_t kWithoutHostNs = 2'000'000'000;
constexpr std::int64_t kWatchStepNs = 10'000;

bool is_driving(const RobotSimulation& simulation) {
  const MotorDuty duty = simulation.motor_duty();
  return duty.left != 0.0 || duty.right != 0.0;
}

}  // namespace

LockstepRun::LockstepRun(RobotSimulation& simulation,
                         ByteEndpoint& endpoint,
                         LockstepServer& server)
    : simulation_(simulation), endpoint_(endpoint), server_(server) {}

LockstepEnd LockstepRun::run() {
  while (!stop_requested()) {
    const auto request = server_.take_request();
    if (!request) {
      wait_readable(endpoint_, server_.descriptor(), kPatience);
      collect_bytes();
      continue;
    }
    if (const auto end = std::visit([this](const auto& what) { return serve(what); }, *request)) {
      return *end;
    }
  }
  return LockstepEnd::kStopSignal;
}

std::optional<LockstepEnd> LockstepRun::serve(const Grant& grant) {
  if (!wait_for_bytes(grant.host_bytes)) {
    return stop_requested() ? LockstepEnd::kStopSignal : LockstepEnd::kHostGone;
  }
  fulfil(grant);
  return std::nullopt;
}

std::optional<LockstepEnd> LockstepRun::serve(const CarryOff& carry) {
  simulation_.carry_off(carry.held_us * 1000);
  return std::nullopt;
}

std::optional<LockstepEnd> LockstepRun::serve(const PutBox& box) {
  const auto metres = [](std::int64_t mm) { return 1e-3 * static_cast<double>(mm); };
  const bool stands =
      simulation_.put_box({metres(box.x_mm), metres(box.y_mm)}, metres(box.side_mm));
  if (on_box) {
    on_box(box, stands);
  }
  return std::nullopt;
}

std::optional<LockstepEnd> LockstepRun::serve(const CutCable& cut) {
  if (on_cut_cable) {
    on_cut_cable(cut.for_us * 1000);
  }
  return std::nullopt;
}

std::optional<LockstepEnd> LockstepRun::serve(const TellTruth&) {
  tells_truth_ = true;
  return std::nullopt;
}

std::optional<LockstepEnd> LockstepRun::serve(const BadRequest& bad) {
  throw std::runtime_error("unexpected lockstep request: " + bad.line);
}

StopReport LockstepRun::run_without_host() {
  StopReport report{simulation_.now_ns(), std::nullopt};
  std::int64_t driving_until_ns = 0;
  for (std::int64_t passed_ns = 0; passed_ns < kWithoutHostNs; passed_ns += kWatchStepNs) {
    if (is_driving(simulation_)) {
      driving_until_ns = passed_ns + kWatchStepNs;
    }
    simulation_.advance_to(report.last_grant_ns + passed_ns + kWatchStepNs);
  }
  if (!is_driving(simulation_)) {
    report.stopped_after_ns = driving_until_ns;
  }
  return report;
}

/// Takes in what the host has sent and pushes on what is on its way to it.
void LockstepRun::collect_bytes() {
  const std::vector<std::uint8_t> bytes = endpoint_.receive();
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  endpoint_.send({});
}

/// Whether they have come; false where the stream has swallowed them.
bool LockstepRun::wait_for_bytes(std::uint64_t host_bytes) {
  const auto end = std::chrono::steady_clock::now() + kBytesPatience;
  collect_bytes();
  while (handed_bytes_ + waiting_.size() < host_bytes) {
    if (stop_requested() || std::chrono::steady_clock::now() > end) {
      return false;
    }
    wait_readable(endpoint_, -1, kPatience);
    collect_bytes();
  }
  return true;
}

void LockstepRun::fulfil(const Grant& grant) {
  std::vector<std::uint8_t> bytes;
  for (; handed_bytes_ < grant.host_bytes; ++handed_bytes_) {
    bytes.push_back(waiting_.front());
    waiting_.pop_front();
  }
  if (!bytes.empty()) {
    simulation_.receive(bytes);
  }
  simulation_.advance_to(grant.until_us * 1000);
  const std::vector<std::uint8_t> sent = simulation_.take_sent();
  device_bytes_ += sent.size();
  endpoint_.send(sent);
  server_.send_reached(
      grant.until_us,
      device_bytes_,
      tells_truth_ ? std::optional(simulation_.world().T_start_robot()) : std::nullopt);
}

}  // namespace echomap::runner
