// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include <boost/asio/ip/tcp.hpp>

#include "host/live_page/connection_list.hpp"
#include "host/live_page/page_router.hpp"
#include "host/live_page/socket_protocol.hpp"

namespace echomap::live_page {

/// What all connections of a server share; it outlives them.
struct ServerParts {
  const PageRouter* router = nullptr;
  std::vector<NamedProtocol> protocols;
  ConnectionList connections;
  std::atomic<std::size_t> sockets = 0;  ///< WebSockets that are open.
};

/// Answers the requests that come by a connection, until its client closes it, is too slow or
/// makes it a WebSocket.
void serve_http(boost::asio::ip::tcp::socket socket, ServerParts& parts);

}  // namespace echomap::live_page
