// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/reliability.hpp"

namespace echomap::bench {

/// What became of a robot in a room, again and again.
struct RoomScore {
  int starts = 0;
  int found = 0;      ///< After ten stops, within 15 cm and 10 degrees.
  int kidnapped = 0;  ///< Of those found, after ten more stops.
  int noticed = 0;    ///< Said so within ten stops, or is right again.
  int recovered = 0;  ///< Found again after ten stops.
  int stops = 0;      ///< Of localized robots that nobody carried off,
  int alarms = 0;     ///< and how often one was called lost.
};

/// `starts` robots in a bundled room, each with a sweep in so many directions at each stop. What
/// was told of being lost, by more than 30 cm or 20 degrees, is added to `reliability`.
RoomScore score_room(const std::string& room,
                     int directions,
                     int starts,
                     std::uint32_t seed,
                     Reliability& reliability);

/// Rates over the five bundled rooms, with 8 and with 60 directions; prints a line a room, and
/// draws how far the probability of being lost holds unless `picture` is empty.
std::vector<Figure> room_figures(int starts,
                                 std::uint32_t seed,
                                 const std::filesystem::path& picture);

}  // namespace echomap::bench
