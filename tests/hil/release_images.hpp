// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace echomap::tests {

/// An image of this build's firmware: "echomap-uno", "echomap-uno-115200", ..
inline std::filesystem::path release_image(const std::string& name) {
  return std::filesystem::path(ECHOMAP_BINARY_DIR) / "firmware" / (name + ".elf");
}

}  // namespace echomap::tests
