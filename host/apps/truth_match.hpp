// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/evaluation/run_score.hpp"

namespace echomap::apps {

/// What the folders of a run and of a truth say about their rooms.
enum class RoomMatch : std::uint8_t {
  kSame,    ///< Both name one world.
  kUnknown  ///< One of them names none, or the run only the file of its own.
};

/// Compares the worlds in summary.json of a run and truth.json of a truth. Throws CommandError 2
/// where they are two, with the command for the run's own truth.
RoomMatch match_rooms(const std::filesystem::path& run, const std::filesystem::path& truth);

/// Throws CommandError 1 where a map agrees so little with the truth, placed by the start and as it
/// fits best, that the truth must be of another room.
void refuse_misfit(const std::filesystem::path& run,
                   const std::filesystem::path& truth,
                   const evaluation::RunScore& score);

}  // namespace echomap::apps
