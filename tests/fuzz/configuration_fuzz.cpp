// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"
#include "host/session/robot_profile.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"

namespace {

using echomap::files::TomlReader;
using echomap::fuzz::require;

/// The kinds of files that a user writes.
enum Kind : std::uint8_t { kRoom, kBody, kProfile, kKinds };

void read_profile(std::span<const std::uint8_t> bytes) {
  static echomap::fuzz::MemoryFile file;
  file.write(bytes);
  const auto profile = echomap::session::load_robot_profile(file.path().string());
  require(profile.ticks_per_s() > 0, "a robot of a profile moves");
  const bool has_reach = std::isfinite(profile.pan_limit_rad) && profile.pan_limit_rad > 0.0;
  require(!profile.has_sonar || has_reach, "the pan of a sonar has a reach");
}

void read(std::uint8_t kind, std::span<const std::uint8_t> bytes) {
  const std::string text = echomap::fuzz::text_of(bytes);
  switch (kind % kKinds) {
    case kRoom:
      echomap::world::read_floor_plan(TomlReader::parse(text, "room.toml"));
      break;
    case kBody:
      echomap::world::read_robot(TomlReader::parse(text, "body.toml"));
      break;
    default:
      read_profile(bytes);
  }
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  const std::filesystem::path tree = ECHOMAP_SOURCE_DIR;
  std::vector<Input> seeds;
  for (const auto& [kind, folder] : {std::pair{kRoom, "hil_mock/worlds"},
                                     std::pair{kBody, "hil_mock/robots"},
                                     std::pair{kProfile, "host/profiles"}}) {
    for (const auto& entry : std::filesystem::directory_iterator(tree / folder)) {
      seeds.push_back(input_of(kind, files::read_text_file(entry.path())));
    }
  }
  return seeds;
}

/// One input is a kind of file and its text. It is read, or refused with a ConfigError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  try {
    read(data[0], {data + 1, size - 1});
  } catch (const echomap::files::ConfigError&) {
  }
  return 0;
}
