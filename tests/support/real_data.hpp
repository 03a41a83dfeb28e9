// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace echomap::tests {

/// A file of the public logs, which are not part of this tree: below ECHOMAP_DATA, or where they
/// lie beside it.
inline std::filesystem::path real_data(const std::string& file) {
  const char* folder = std::getenv("ECHOMAP_DATA");
  const bool is_chosen = folder != nullptr && *folder != '\0';
  return std::filesystem::path(is_chosen ? folder : ECHOMAP_SOURCE_DIR "/../shared/data") / file;
}

}  // namespace echomap::tests

/// Skips the test where a public log is not there.
#define ECHOMAP_SKIP_WITHOUT(path)                                           \
  if (!std::filesystem::exists(path)) {                                      \
    GTEST_SKIP() << (path) << " is not here; ECHOMAP_DATA names its folder"; \
  }
