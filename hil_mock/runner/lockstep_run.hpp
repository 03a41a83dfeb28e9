// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "hil_mock/runner/lockstep_seat.hpp"
#include "hil_mock/runner/robot_team.hpp"

namespace echomap::runner {

/// How the wheels came to rest after the host had vanished.
struct StopReport {
  /// The end of the host's last grant.
  std::int64_t last_grant_ns = 0;
  /// From there until both duties stayed at zero; empty where they did not in two seconds.
  std::optional<std::int64_t> stopped_after_ns;
};

/// Why a run in lockstep has ended.
enum class LockstepEnd : std::uint8_t { kQuit, kHostGone, kStopSignal };

/// Serves the host of each robot of a team in lockstep: simulated time passes only as far as all of
/// them have granted, and only after every byte of theirs has come. A host that has not connected
/// yet holds it at the start; one that has quit or vanished holds it no longer.
class LockstepRun {
 public:
  /// `seats` are of all robots of the team, in its order. Both must outlive this.
  LockstepRun(RobotTeam& team, std::vector<LockstepSeat>& seats);

  /// Until every host has quit or vanished, those that have vanished two simulated seconds ago, or
  /// a stop signal comes. Throws std::runtime_error for a line that is none of the protocol's.
  void run();

  /// Called when somebody has put a box down, or could not: it `stands` there or it does not.
  std::function<void(std::size_t robot, const PutBox& box, bool stands)> on_box;

  /// Called when a cable is pulled: for so long of simulated time nothing is to pass.
  std::function<void(std::size_t robot, std::int64_t for_ns)> on_cut_cable;

  /// Called once for each robot, when its host is served no more; with a report where the host has
  /// vanished, two simulated seconds later.
  std::function<void(std::size_t robot, LockstepEnd end, const std::optional<StopReport>& stop)>
      on_end;

 private:
  /// Of a robot whose host has vanished.
  struct WheelWatch {
    std::int64_t last_grant_ns = 0;
    std::int64_t driving_until_ns = 0;
  };
  struct Served {
    LockstepSeat* seat = nullptr;
    std::size_t robot = 0;
    bool has_host = true;
    std::optional<WheelWatch> watch = std::nullopt;
  };

  bool is_over() const;
  bool hear_hosts();
  bool is_granted() const;
  void wait_for_hosts() const;
  std::int64_t granted_by_all_ns() const;
  void advance_to(std::int64_t until_ns);
  void watch_wheels(std::int64_t until_ns);
  void end_watch(Served& served);
  void end(Served& served, LockstepEnd why, const std::optional<StopReport>& stop) const;

  void serve(Served& served, const Grant& grant);
  static void serve(Served& served, const CarryOff& carry);
  void serve(Served& served, const PutBox& box);
  void serve(Served& served, const CutCable& cut);
  static void serve(Served& served, const TellTruth&) { served.seat->tell_truth(); }
  void serve(Served& served, const Quit&) { end(served, LockstepEnd::kQuit, std::nullopt); }
  void serve(Served& served, const HostGone&);
  static void serve(Served& served, const BadRequest& bad);

  RobotTeam& team_;
  std::vector<Served> served_;
};

}  // namespace echomap::runner
