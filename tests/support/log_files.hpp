// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>
#include <zlib.h>

#include "host/datasets/log_reader.hpp"

namespace echomap::tests {

/// Packs a text.
inline void write_gz(const std::filesystem::path& path, std::string_view text) {
  gzFile file = ::gzopen(path.c_str(), "wb");
  const int written = ::gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  ::gzclose(file);
  if (written != static_cast<int>(text.size())) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

/// All records of a log.
inline std::vector<datasets::LogRecord> records_of(datasets::LogReader& log) {
  std::vector<datasets::LogRecord> records;
  while (auto record = log.next()) {
    records.push_back(std::move(*record));
  }
  return records;
}

/// Those of one kind.
template <class Kind>
std::vector<Kind> only(const std::vector<datasets::LogRecord>& records) {
  std::vector<Kind> chosen;
  for (const auto& record : records) {
    if (const auto* kind = std::get_if<Kind>(&record)) {
      chosen.push_back(*kind);
    }
  }
  return chosen;
}

}  // namespace echomap::tests
