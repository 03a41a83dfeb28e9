// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "host/apps/commands.hpp"
#include "host/live_page/page_server.hpp"

namespace echomap::apps {

/// Serves the page where the options say, prints its URL and opens it where there is a desktop.
/// `protocols` are what it speaks beside echomap.v1. Where the usual port is taken it takes another
/// one; an address that others reach gets a token. Throws CommandError.
std::unique_ptr<live_page::PageServer> serve_page(
    const LiveOptions& options,
    std::vector<live_page::ServedRun> runs,
    const std::vector<std::string>& can = {},
    live_page::PageServer::TakeCommand take_command = nullptr,
    std::vector<live_page::NamedProtocol> protocols = {});

/// Until nobody watches any more, or until Ctrl-C. Returns at once where nobody does. A page that
/// is loaded anew may be `away` for a moment.
void wait_while_watched(const live_page::PageServer& server,
                        std::chrono::milliseconds away = std::chrono::seconds(3));

/// Until Ctrl-C.
void wait_for_interrupt();

}  // namespace echomap::apps
