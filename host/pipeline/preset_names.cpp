// SPDX-License-Identifier: MIT
#include "host/pipeline/preset_names.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "host/files/nearest_word.hpp"

namespace echomap::pipeline {

namespace {

using localization::LocalizerPreset;

constexpr std::array<std::pair<const char*, LocalizerPreset>, 4> kPresets = {
    {{"default", LocalizerPreset::kDefault},
     {"nxt", LocalizerPreset::kNxt},
     {"create", LocalizerPreset::kCreate},
     {"epuck", LocalizerPreset::kEpuck}}};

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  std::transform(
      kPresets.begin(), kPresets.end(), std::back_inserter(names), [](const auto& entry) {
        return entry.first;
      });
  return names;
}

LocalizerPreset preset_named(std::string_view name) {
  const auto found = std::find_if(
      kPresets.begin(), kPresets.end(), [&](const auto& entry) { return name == entry.first; });
  if (found == kPresets.end()) {
    throw std::invalid_argument("unknown preset '" + std::string(name) + "'" +
                                files::suggestion(name, preset_names()));
  }
  return found->second;
}

std::string name_of(LocalizerPreset preset) {
  const auto found = std::find_if(
      kPresets.begin(), kPresets.end(), [&](const auto& entry) { return preset == entry.second; });
  return found->first;
}

}  // namespace echomap::pipeline
