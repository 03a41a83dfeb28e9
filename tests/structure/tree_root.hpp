// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace echomap::structure {

/// The root of the tree that this program was built from.
inline const std::filesystem::path tree_root = ECHOMAP_SOURCE_DIR;

}  // namespace echomap::structure
