// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/localization/localizer_preset.hpp"

namespace echomap::pipeline {

/// The names of all presets, as users write them: default, nxt, create, epuck.
std::vector<std::string> preset_names();

/// The preset of a name. Throws std::invalid_argument with the nearest name where there is none.
localization::LocalizerPreset preset_named(std::string_view name);

/// The name of a preset.
std::string name_of(localization::LocalizerPreset preset);

}  // namespace echomap::pipeline
