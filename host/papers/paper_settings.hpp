// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace echomap::papers {

/// How the experiments of a paper are repeated.
struct PaperSettings {
  std::uint32_t seed = 1;     ///< Of the first run; the others count on from it.
  std::size_t runs = 20;      ///< Of each experiment with a random outcome.
  std::filesystem::path out;  ///< Folder of the runs that leave files.
  /// Called with what is going on, and how many of how many runs have ended.
  std::function<void(const std::string& what, std::size_t ended, std::size_t runs)> progress =
      [](const std::string&, std::size_t, std::size_t) {};
};

}  // namespace echomap::papers
