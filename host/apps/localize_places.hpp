// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "host/apps/commands.hpp"

namespace echomap::apps {

/// DIR of `--map places=DIR`; empty for a map.
std::optional<std::filesystem::path> places_of(const std::filesystem::path& map);

/// `echomap localize LOG --map places=DIR`: names the place of DIR, of which each file is the sweep
/// of one, where the log's sweep was taken, and how the robot is turned
/// (localization::recognise_place). Writes summary.json into `out`. Unsure where the next place
/// fits nearly as well. Throws CommandError and files::FileError.
ExitCode localize_in_places(const LocalizeOptions& options, const std::filesystem::path& out);

}  // namespace echomap::apps
