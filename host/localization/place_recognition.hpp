// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace echomap::localization {

/// Ranges all round from one place, at even steps of a full turn, counter-clockwise; empty where
/// nothing returned.
using RoundScan = std::vector<std::optional<double>>;

/// A place that was seen before.
struct RecognisedPlace {
  std::size_t place = 0;
  /// The robot stands turned by so much against then, counter-clockwise, in [0, 2 pi).
  double turn_rad = 0.0;
  /// Mean difference of a range, metres, at that place and at the next best one.
  double difference_m = 0.0;
  double next_difference_m = 0.0;
};

/// The place whose scan is the likest to one that was taken now, turned in any way: the mean over
/// all ranges of their difference is the least, where one counts as `max_m` at most. So does
/// silence against a range: what nothing returns from may be any distance off. Ours, for robots
/// without a map, as the matching of signatures by circular shifts is usual. Empty for no places.
/// Throws std::invalid_argument for scans of different lengths or of none, and for `max_m` not
/// above 0.
std::optional<RecognisedPlace> recognise_place(const RoundScan& scan,
                                               std::span<const RoundScan> places,
                                               double max_m = 0.5);

}  // namespace echomap::localization
