// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace echomap::papers {

/// Runs `echomap demo --headless --no-kidnap` with these arguments into `out`, its words beside it;
/// answers its report. The calling test fails where it ends with an error.
nlohmann::json run_demo(std::vector<std::string> arguments, const std::filesystem::path& out);

}  // namespace echomap::papers
