// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/pipeline/seen_landmark.hpp"

namespace echomap::exports {

/// landmarks.csv: a header line, then one sighting a line as
/// `stamp_s,id,range_m,bearing_rad,x_m,y_m`; bearing in the robot's frame, place in the map frame,
/// the stamp that of a line of trajectory.tum. Numbers are the shortest that read back the same.
/// Throws files::FileError.
void write_landmarks_csv(const std::filesystem::path& path,
                         const std::vector<pipeline::SeenLandmark>& landmarks);

}  // namespace echomap::exports
