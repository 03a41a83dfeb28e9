// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_run.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <variant>

#include "hil_mock/runner/stop_signal.hpp"
#include "hil_mock/runner/wait_readable.hpp"

namespace echomap::runner {
namespace {

/// Longest wait before the next look at the stop signal.
constexpr std::chrono::milliseconds kPatience{100};
constexpr std::int64_t kWithoutHostNs = 2'000'000'000;
constexpr std::int64_t kWatchStepNs = 10'000;

bool is_driving(const RobotSimulation& simulation) {
  const MotorDuty duty = simulation.motor_duty();
  return duty.left != 0.0 || duty.right != 0.0;
}

}  // namespace

LockstepRun::LockstepRun(RobotTeam& team, std::vector<LockstepSeat>& seats) : team_(team) {
  for (LockstepSeat& seat : seats) {
    served_.push_back({&seat, served_.size()});
  }
}

void LockstepRun::run() {
  while (!stop_requested() && !is_over()) {
    if (hear_hosts()) {
      continue;
    }
    if (is_granted()) {
      advance_to(granted_by_all_ns());
    } else {
      wait_for_hosts();
    }
  }
  for (Served& served : served_) {
    if (served.has_host) {
      end(served, LockstepEnd::kStopSignal, std::nullopt);
    }
    end_watch(served);
  }
}

bool LockstepRun::is_over() const {
  return std::ranges::none_of(served_,
                              [](const Served& served) { return served.has_host || served.watch; });
}

/// Serves what those who have granted no time want. False where nobody has said anything.
bool LockstepRun::hear_hosts() {
  bool heard = false;
  for (Served& served : served_) {
    if (!served.has_host || served.seat->granted_ns()) {
      continue;
    }
    if (const auto request = served.seat->take_request()) {
      std::visit([&](const auto& what) { serve(served, what); }, *request);
      heard = true;
    }
  }
  return heard;
}

bool LockstepRun::is_granted() const {
  return std::ranges::none_of(
      served_, [](const Served& served) { return served.has_host && !served.seat->granted_ns(); });
}

void LockstepRun::wait_for_hosts() const {
  std::vector<Awaited> awaited;
  for (const Served& served : served_) {
    if (served.has_host && !served.seat->granted_ns()) {
      awaited.push_back({&served.seat->endpoint(), served.seat->descriptor()});
    }
  }
  wait_readable(awaited, kPatience);
  for (const Served& served : served_) {
    if (served.has_host && !served.seat->granted_ns()) {
      served.seat->collect_bytes();
    }
  }
}

/// Where no host is left, the end of the last watch.
std::int64_t LockstepRun::granted_by_all_ns() const {
  std::int64_t granted_ns = std::numeric_limits<std::int64_t>::max();
  std::int64_t watched_ns = 0;
  for (const Served& served : served_) {
    if (served.has_host) {
      granted_ns = std::min(granted_ns, served.seat->granted_ns().value_or(granted_ns));
    } else if (served.watch) {
      watched_ns = std::max(watched_ns, served.watch->last_grant_ns + kWithoutHostNs);
    }
  }
  const bool has_host = std::ranges::any_of(served_, &Served::has_host);
  return has_host ? granted_ns : watched_ns;
}

/// And answers those whose grants are reached.
void LockstepRun::advance_to(std::int64_t until_ns) {
  while (team_.now_ns() < until_ns) {
    const bool watches =
        std::ranges::any_of(served_, [](const Served& served) { return served.watch.has_value(); });
    const std::int64_t next_ns =
        watches ? std::min(until_ns, team_.now_ns() + kWatchStepNs) : until_ns;
    watch_wheels(next_ns);
    team_.advance_to(next_ns);
    for (Served& served : served_) {
      if (served.watch && next_ns >= served.watch->last_grant_ns + kWithoutHostNs) {
        end_watch(served);
      }
    }
  }
  for (const Served& served : served_) {
    if (!served.has_host) {
      served.seat->discard_sent();
    } else if (served.seat->granted_ns() <= until_ns) {
      served.seat->answer();
    }
  }
}

void LockstepRun::watch_wheels(std::int64_t until_ns) {
  for (Served& served : served_) {
    if (served.watch && is_driving(served.seat->simulation())) {
      served.watch->driving_until_ns = until_ns;
    }
  }
}

void LockstepRun::end_watch(Served& served) {
  if (!served.watch) {
    return;
  }
  StopReport report{served.watch->last_grant_ns, std::nullopt};
  if (!is_driving(served.seat->simulation())) {
    report.stopped_after_ns =
        std::max<std::int64_t>(0, served.watch->driving_until_ns - report.last_grant_ns);
  }
  served.watch.reset();
  end(served, LockstepEnd::kHostGone, report);
}

void LockstepRun::end(Served& served,
                      LockstepEnd why,
                      const std::optional<StopReport>& stop) const {
  served.has_host = false;
  if (on_end) {
    on_end(served.robot, why, stop);
  }
}

void LockstepRun::serve(Served& served, const Grant& grant) {
  if (!served.seat->accept(grant)) {
    if (!stop_requested()) {
      serve(served, HostGone{});
    }
    return;
  }
  if (served.seat->granted_ns() <= team_.now_ns()) {
    served.seat->answer();
  }
}

void LockstepRun::serve(Served& served, const CarryOff& carry) {
  served.seat->simulation().carry_off(carry.held_us * 1000);
}

void LockstepRun::serve(Served& served, const PutBox& box) {
  const auto metres = [](std::int64_t mm) { return 1e-3 * static_cast<double>(mm); };
  const bool stands =
      team_.put_box(served.robot, {metres(box.x_mm), metres(box.y_mm)}, metres(box.side_mm));
  if (on_box) {
    on_box(served.robot, box, stands);
  }
}

void LockstepRun::serve(Served& served, const CutCable& cut) {
  if (on_cut_cable) {
    on_cut_cable(served.robot, cut.for_us * 1000);
  }
}

/// Its wheels are watched from now on.
void LockstepRun::serve(Served& served, const HostGone&) {
  served.has_host = false;
  served.watch = WheelWatch{team_.now_ns(), 0};
}

void LockstepRun::serve(Served& /*served*/, const BadRequest& bad) {
  throw std::runtime_error("unexpected lockstep request: " + bad.line);
}

}  // namespace echomap::runner
