// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/recording/session_file.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/session_player.hpp"

namespace echomap::tests {

/// Plays the recording of a run into a sink, or into an atlas with the decisions about its maps.
inline void play_recording(const std::filesystem::path& file,
                           pipeline::ObservationSink& sink,
                           pipeline::RobotAtlas* atlas = nullptr) {
  recording::SessionReader recording(file);
  const session::RobotProfile profile =
      session::parse_robot_profile(recording.attachment("robot.toml").value(), "robot.toml");
  pipeline::JoinedSessions sessions(sink);
  session::SessionPlayer player(recording, profile, {sessions, sink, atlas});
  while (player.play_next()) {
  }
}

}  // namespace echomap::tests
