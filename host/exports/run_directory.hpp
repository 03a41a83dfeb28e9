// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <Eigen/Core>

#include "host/exports/summary_json.hpp"
#include "host/geometry/polygon.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// Sets the fields of a summary that follow from what the pipeline knows: stops, poses, points,
/// length and area.
void describe_snapshot(const pipeline::Snapshot& snapshot, RunSummary& summary);

/// Sets what the covariance of x, y (m) and heading (rad) says of the last pose.
void describe_uncertainty(const Eigen::Matrix3d& covariance, RunSummary& summary);

/// Writes map.yaml, map.pgm, occupancy_grid.csv, map.png, map.svg, outline.geojson, points.csv,
/// poses.csv, trajectory.tum and summary.json into `directory`, which is made where it is missing.
/// Each file is whole or absent. The outline is `outline_m`, or that of the grid's free floor where
/// it is empty. Throws files::FileError, and std::invalid_argument for an outline that is none.
void write_run_directory(const std::filesystem::path& directory,
                         const pipeline::Snapshot& snapshot,
                         const RunSummary& summary,
                         const geometry::Polygon& outline_m = {});

}  // namespace echomap::exports
