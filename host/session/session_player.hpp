// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/recording/session_reader.hpp"
#include "host/recording/session_recorder.hpp"
#include "host/session/observation_feed.hpp"
#include "host/session/robot_profile.hpp"
#include "protocol/link.hpp"

namespace echomap::session {

/// Where a recording is played to; all outlive the player.
struct PlayedInto {
  /// Take what the frames say; lead to `joined`.
  pipeline::JoinedSessions& sessions;
  /// Takes scans and pose fixes, which are of all sessions alike.
  pipeline::ObservationSink& joined;
  /// Carries out the decisions about the maps; null for none.
  pipeline::RobotAtlas* atlas = nullptr;
  /// Records again what is played; null for nobody.
  recording::SessionRecorder* recorder = nullptr;
};

/// Plays the frames and events of a recorded session into the sinks that a live one has: decoding,
/// conversion and maps are the same code, so that what comes out is the same to the bit.
class SessionPlayer {
 public:
  SessionPlayer(recording::SessionReader& recording,
                const RobotProfile& profile,
                const PlayedInto& into);

  /// Leaves out observations and events before one second of the recording, and ends at another.
  void play_between(double begin_s, double end_s) {
    begin_s_ = begin_s;
    end_s_ = end_s;
  }

  /// Plays the next entry; false behind the last one that concerns the maps. Throws
  /// files::FileError as recording::SessionReader::next does.
  bool play_next();
  /// Whether the last entry ended a scan.
  bool has_ended_scan() const { return has_ended_scan_; }
  /// The observations that were played, with events.
  std::size_t observations() const { return observations_; }

 private:
  void play(const recording::RecordedFrame& recorded);
  /// Hands on what the frame says.
  void observe(const recording::LineFrame& frame);
  void play(const recording::SessionEvent& event);
  void play_into_maps(const recording::SessionEvent& event);
  void play_of_session(const recording::SessionEvent& event);
  void begin_session();
  bool can_change_maps() const { return into_.atlas != nullptr && !is_left_out(); }
  bool is_left_out() const { return recording_.elapsed_s() < begin_s_; }

  recording::SessionReader& recording_;
  const RobotProfile& profile_;
  PlayedInto into_;
  std::optional<ObservationFeed> feed_;
  double begin_s_ = 0.0;
  double end_s_ = std::numeric_limits<double>::infinity();
  std::size_t observations_ = 0;
  bool has_ended_scan_ = false;
  bool has_ended_ = false;
};

}  // namespace echomap::session
