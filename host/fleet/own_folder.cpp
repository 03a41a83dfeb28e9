// SPDX-License-Identifier: MIT
#include "host/fleet/own_folder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <system_error>
#include <utility>

#include "host/files/atomic_file.hpp"

namespace echomap::fleet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kObject = "1-object";

/// Those of objects sort before those of graphs, and by their number.
std::string numbered_name(const char* kind, std::size_t number) {
  char name[64];
  std::snprintf(name, sizeof(name), "%s-%08zu.bin", kind, number);
  return name;
}

/// Of a file of an object; 0 of any other.
std::size_t object_number(const std::string& name) {
  std::size_t number = 0;
  const std::string pattern = std::string(kObject) + "-%zu.bin";
  return std::sscanf(name.c_str(), pattern.c_str(), &number) == 1 ? number : 0;
}

}  // namespace

OwnFolder::OwnFolder(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) {
    return;
  }
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) {
    throw files::FileError(path_.string() + ": cannot make the folder: " + error.message());
  }
}

std::vector<std::string> OwnFolder::load() {
  std::vector<std::string> payloads;
  if (path_.empty()) {
    return payloads;
  }
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(path_, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".bin") {
      files.push_back(entry->path());
    }
  }
  if (error) {
    throw files::FileError(path_.string() + ": cannot list the folder: " + error.message());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& one, const fs::path& other) {
    return one.filename().string() < other.filename().string();
  });
  for (const fs::path& file : files) {
    payloads.push_back(files::read_text_file(file));
    next_object_ = std::max(next_object_, object_number(file.filename().string()) + 1);
  }
  return payloads;
}

bool OwnFolder::save_object(const std::string& payload) {
  return save(numbered_name(kObject, next_object_++), payload);
}

bool OwnFolder::save_graph(std::uint16_t map_number, const std::string& payload) const {
  return save(numbered_name("2-graph", map_number), payload);
}

bool OwnFolder::save(const std::string& name, const std::string& payload) const {
  if (path_.empty()) {
    return true;
  }
  try {
    files::write_text_file(path_ / name, payload);
    return true;
  } catch (const files::FileError&) {
    return false;
  }
}

}  // namespace echomap::fleet
