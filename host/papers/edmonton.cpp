// SPDX-License-Identifier: MIT
#include "host/papers/edmonton.hpp"

#include <cstdlib>
#include <utility>

#include "host/datasets/edmonton_log.hpp"
#include "host/files/bundled_files.hpp"

namespace echomap::papers {

std::filesystem::path public_logs() {
  const char* folder = std::getenv("ECHOMAP_DATA");
  const bool is_chosen = folder != nullptr && *folder != '\0';
  return is_chosen ? std::filesystem::path(folder)
                   : files::bundled_folder("host").parent_path() / "../shared/data";
}

std::filesystem::path edmonton_scans(const std::filesystem::path& logs) {
  const auto plain = logs / "edmonton" / "dataset_edmonton.rawlog_LASER.txt";
  return exists(plain) ? plain : std::filesystem::path(plain.string() + ".gz");
}

std::optional<EdmontonLog> read_edmonton(const std::filesystem::path& logs) {
  const auto scans = edmonton_scans(logs);
  if (!exists(scans)) {
    return std::nullopt;
  }
  EdmontonLog log;
  const auto reader = datasets::open_edmonton_log(scans);
  while (auto record = reader->next()) {
    log.records.push_back(std::move(*record));
  }
  const auto relations = logs / "slam_relations" / "edm.assoc.gz";
  if (exists(relations)) {
    log.relations = evaluation::read_relations(relations);
  }
  return log;
}

}  // namespace echomap::papers
