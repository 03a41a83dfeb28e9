// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// trajectory.tum: one pose a line as `t x y z qx qy qz qw`, seconds of the robot's clock and
/// metres of the map frame, eight columns, single spaces: the TUM format as evo reads it. Throws
/// files::FileError.
void write_trajectory_tum(const std::filesystem::path& path,
                          const std::vector<pipeline::StampedPose>& trajectory);

/// Stamps are rounded to microseconds; the rotation about z is kept. Lines that begin with # are
/// skipped. Throws files::FileError whose text begins `file:line: `.
std::vector<pipeline::StampedPose> read_trajectory_tum(const std::filesystem::path& path);

}  // namespace echomap::exports
