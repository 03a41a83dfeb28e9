// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/apps/commands.hpp"
#include "tests/host/live_page/read_messages.hpp"
#include "tests/host/live_page/web_client.hpp"

namespace echomap::apps {

/// A page at a port that is free.
inline LiveOptions page_at_any_port() { return {true, "127.0.0.1:0", false}; }

/// The first port that a text names in a URL.
inline std::uint16_t port_in(const std::string& text) {
  const std::size_t host = text.find("http://") + 7;
  const std::size_t colon = text.rfind(':', text.find('/', host));
  return static_cast<std::uint16_t>(std::stoi(text.substr(colon + 1)));
}

/// All messages of a run so far, as a page gets them.
inline std::vector<live_page::Message> visited_history(std::uint16_t port,
                                                       const std::string& run = "0") {
  const std::string target = "/api/v1/runs/" + run + "/history";
  const live_page::HttpReply reply = live_page::WebClient(port).ask(live_page::get(port, target));
  EXPECT_EQ(reply.status, 200) << target;
  return live_page::messages_in(reply.body);
}

/// Those of one kind.
inline std::vector<live_page::Message> of_kind(const std::vector<live_page::Message>& messages,
                                               live_page::MessageKind kind) {
  std::vector<live_page::Message> found;
  for (const live_page::Message& message : messages) {
    if (message.kind == kind) {
      found.push_back(message);
    }
  }
  return found;
}

}  // namespace echomap::apps
