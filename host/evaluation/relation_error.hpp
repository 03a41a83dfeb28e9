// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::evaluation {

/// What is known of the way between two records of a log: the robot's pose at `to`, seen from its
/// pose at `from`.
struct PoseRelation {
  std::size_t from = 0;
  std::size_t to = 0;
  geometry::Pose2 T_from_to;
};

/// How far the relations of a trajectory are off the known ones (Kuemmerle et al. 2009): mean and
/// standard deviation over the relations, of distance and of turn.
struct RelationError {
  std::size_t relations = 0;
  double translation_mean_m = 0.0;
  double translation_stddev_m = 0.0;
  double rotation_mean_rad = 0.0;
  double rotation_stddev_rad = 0.0;
};

/// Reads lines `from to dx_m dy_m dtheta_rad` of a file, plain or gz. Throws files::FileError whose
/// text begins `file:line: `.
std::vector<PoseRelation> read_relations(const std::filesystem::path& path);

/// Compares with one pose for each record, in any frame: nothing is aligned. Throws
/// std::invalid_argument where there is no relation, or one names a record without a pose.
RelationError score_relations(const std::vector<geometry::Pose2>& trajectory,
                              const std::vector<PoseRelation>& relations);

}  // namespace echomap::evaluation
