// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/robot_link/link_state.hpp"
#include "host/robot_link/robot_link_params.hpp"
#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// Watches what comes over the line and when: whether the robot must be asked, whether it is lost,
/// and what is wrong where none answers.
class LineWatch {
 public:
  explicit LineWatch(const RobotLinkParams& params)
      : hello_period_(params.hello_period),
        quiet_after_(params.quiet_after),
        lost_after_(params.lost_after),
        diagnose_after_(params.diagnose_after) {}

  void note_byte(time::HostTime now) { last_byte_at_ = now; }
  void note_frame(time::HostTime now) { last_frame_at_ = now; }
  void note_hello(time::HostTime now) { next_hello_ = now + hello_period_; }
  /// A new search for the robot begins.
  void begin_search(time::HostTime now) { searching_since_ = now; }

  /// What `state` has become with time: a ready link is lost after a silence, and a search that
  /// finds nothing ends in what is wrong. The first search begins with the first call.
  LinkState next_state(LinkState state, time::HostTime now);
  /// Hello is said while no robot answers, and asks one that has fallen quiet.
  bool is_hello_due(LinkState state, time::HostTime now) const;
  /// The frames of a ready link have stayed away for too long.
  bool is_lost(time::HostTime now) const { return !is_within(lost_after_, last_frame_at_, now); }

 private:
  using Duration = RobotLinkParams::Duration;

  /// True when `instant` lies no longer than `duration` back.
  static bool is_within(Duration duration,
                        const std::optional<time::HostTime>& instant,
                        time::HostTime now) {
    return instant && now - *instant <= duration;
  }

  LinkState diagnose(time::HostTime now);

  Duration hello_period_;
  Duration quiet_after_;
  Duration lost_after_;
  Duration diagnose_after_;
  time::HostTime next_hello_;
  std::optional<time::HostTime> searching_since_;
  std::optional<time::HostTime> last_byte_at_;
  std::optional<time::HostTime> last_frame_at_;
};

}  // namespace echomap::robot_link
