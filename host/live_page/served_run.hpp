// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "host/live_page/history.hpp"

namespace echomap::live_page {

/// A run that the page shows.
struct ServedRun {
  std::string name;              ///< For people.
  std::filesystem::path folder;  ///< Whose files can be downloaded; empty: none.
  std::shared_ptr<History> history;
  bool live = false;  ///< One run at most: it takes commands.
};

}  // namespace echomap::live_page
