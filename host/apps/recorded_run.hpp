// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "host/geometry/polygon.hpp"
#include "host/pipeline/observation_log.hpp"
#include "host/recording/session_reader.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/session_player.hpp"

namespace echomap::apps {

/// What the recording of `echomap localize` names as its command: its report is not one of a map.
inline constexpr const char* kLocalizeCommand = "localize";

/// The recording of a run: that in its run directory, or the file itself. Empty where the path is
/// no such directory and no recording of echomap. Throws files::FileError where a file cannot be
/// read.
std::optional<std::filesystem::path> recording_of(const std::filesystem::path& path);

/// The profile of the robot that drove, as the recording has it. Throws files::FileError where it
/// has none, and files::ConfigError.
session::RobotProfile profile_of(const recording::SessionReader& recording);

/// The report of a run, and what of it is needed to draw its map again.
struct RunReport {
  nlohmann::ordered_json json;
  std::string slam;
  std::string world;
  std::string robot;
  bool outline_by_strategy = false;
};

/// The report in the run directory or, where only the recording is there, the one in it; of a run
/// that was killed before its first stop, what it had set out to do. `log`
/// is what `recording_of` was given; the recording has been read to its end. Throws
/// files::FileError.
RunReport read_report(const std::filesystem::path& log, const recording::SessionReader& recording);

/// The outline that the strategy has drawn itself, from the same place; empty where it drew none.
geometry::Polygon outline_of(const std::filesystem::path& log,
                             const RunReport& report,
                             const recording::SessionReader& recording);

/// Which part of a recording is played, and how fast. Seconds count from its first message.
struct PlayedPart {
  double from_s = 0.0;
  double until_s = std::numeric_limits<double>::infinity();
  /// Seconds of the recording a second; empty: as fast as it goes.
  std::optional<double> speed{};

  bool operator==(const PlayedPart&) const = default;
};

/// How a recording was played.
struct Played {
  std::size_t observations = 0;
  double duration_s = 0.0;  ///< From the first message to the last that was played.
  std::string damage;       ///< What ended it early; empty where nothing did.
  bool is_whole = true;     ///< False where the recording was cut off, or has no ending.
};

/// Throws CommandError where a part has no length, or the speed is none.
void validate(const PlayedPart& part);

/// Throws CommandError where nothing was played, and says whether the part or the recording was
/// empty.
void throw_if_empty(const pipeline::ObservationLog& played,
                    const PlayedPart& part,
                    const recording::SessionReader& recording);

/// Throws CommandError where the run has only localized: it has no map.
void throw_if_without_map(const recording::SessionReader& recording);

/// Plays that part of a recording; calls `on_stop` at the end of every scan. Where the file is
/// damaged, what comes before is played; where it was cut off, as by a power cut, that is warned of
/// and no damage. Throws CommandError at an interrupt.
Played play(
    recording::SessionReader& recording,
    const session::RobotProfile& profile,
    const session::PlayedInto& into,
    const PlayedPart& part = {},
    const std::function<void()>& on_stop = [] {});

}  // namespace echomap::apps
