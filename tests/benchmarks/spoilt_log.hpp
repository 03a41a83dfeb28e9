// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <random>
#include <string>

#include "tests/benchmarks/relation_log.hpp"

namespace echomap::bench {

/// A log of data/carmen_corrected or data/carmen_raw, named by its file, without `.log.gz`, whose
/// odometry was taken out: every `every`th scan, with an odometry made of the poses that the log
/// brings, badly. A base draws once by how much its wheels are off: the way by 3 %, turns by 10 %,
/// and a drift of 2 degrees a metre (1 sigma each); every step adds 2 % and 1 degree a metre of
/// noise. Relations are those of the brought poses: from each metre of the way to the next, and to
/// the nearest place of 10 m of way before or more, if that is within a metre. Empty where the data
/// is not there. Throws files::FileError.
std::optional<RelationLog> read_spoilt_log(const std::string& file,
                                           std::size_t every,
                                           std::mt19937& random);

}  // namespace echomap::bench
