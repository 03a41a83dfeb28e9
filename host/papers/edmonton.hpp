// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/evaluation/relation_error.hpp"

namespace echomap::papers {

/// The Edmonton log in the paper's form.
struct EdmontonLog {
  std::vector<datasets::LogRecord> records;
  /// Known relations between its scans (Kuemmerle et al. 2009); empty where their file is absent.
  std::vector<evaluation::PoseRelation> relations;
};

/// The folder of public logs: what ECHOMAP_DATA names, otherwise shared/data beside the repository.
std::filesystem::path public_logs();

/// The log's file of scans below `logs`, plain or gz, whether it is there or not.
std::filesystem::path edmonton_scans(const std::filesystem::path& logs);

/// Reads `edmonton_scans` and, where it is there, slam_relations/edm.assoc.gz. Empty where there
/// are no scans. Throws files::FileError.
std::optional<EdmontonLog> read_edmonton(const std::filesystem::path& logs);

}  // namespace echomap::papers
