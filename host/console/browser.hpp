// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::console {

/// Whether a browser can be seen by whoever has started this program: a desktop, and not by ssh.
bool has_desktop();

/// Lets the desktop open `url`, without waiting; false where nothing can be started for it.
bool open_in_browser(const std::string& url);

}  // namespace echomap::console
