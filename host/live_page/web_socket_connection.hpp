// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <boost/beast/core/tcp_stream.hpp>

#include "host/live_page/beast_request.hpp"
#include "host/live_page/http_connection.hpp"

namespace echomap::live_page {

/// Answers a request for a WebSocket and speaks the sub-protocol, one of `parts`, until either end
/// closes it or the client does not read.
void serve_web_socket(boost::beast::tcp_stream stream,
                      BeastRequest request,
                      const std::string& protocol,
                      ServerParts& parts);

}  // namespace echomap::live_page
