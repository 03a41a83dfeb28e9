// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "host/mcap/mcap_reader.hpp"

namespace echomap::tests {

/// All records of a whole file.
inline std::vector<mcap::Record> all_records(const std::filesystem::path& file) {
  std::vector<mcap::Record> records;
  mcap::McapReader reader(file);
  for (auto record = reader.next(); record; record = reader.next()) {
    records.push_back(*record);
  }
  return records;
}

/// Its messages.
inline std::vector<mcap::Message> all_messages(const std::filesystem::path& file) {
  std::vector<mcap::Message> messages;
  for (const mcap::Record& record : all_records(file)) {
    if (const auto* message = std::get_if<mcap::Message>(&record)) {
      messages.push_back(*message);
    }
  }
  return messages;
}

}  // namespace echomap::tests
