// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/evaluation/relation_error.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::bench {

/// A laser log with known relations between its poses (Kuemmerle et al. 2009).
struct RelationLog {
  std::vector<datasets::LogRecord> records;
  std::vector<evaluation::PoseRelation> relations;
};

/// `edm` or `fr079` of data/slam_relations; empty where the data is not there. Throws
/// files::FileError.
std::optional<RelationLog> read_relation_log(const std::string& name);

/// The log with only `count` beams of each scan, evenly spread: those of data/slam_relations.
RelationLog with_beams(const RelationLog& log, std::size_t count);

/// The log as `count` sonars would have heard it that are evenly spread over the laser's view:
/// cones of 15 degrees, the nearest beam within, 4 m of reach, 1 cm of noise. As in
/// data/slam_relations, nothing is thrown aside.
RelationLog with_cones(const RelationLog& log, std::size_t count, std::mt19937& random);

/// What odometry alone scores.
evaluation::RelationError score_odometry(const RelationLog& log);

/// Runs a way of doing SLAM over the log, and scores what it says of the trajectory at the end.
evaluation::RelationError score_slam(const RelationLog& log, slam::SlamMethod& method);

}  // namespace echomap::bench
