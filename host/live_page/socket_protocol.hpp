// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "host/live_page/frame.hpp"

namespace echomap::live_page {

/// Sends to one client, from any thread; after the client is gone nothing happens any more.
class FrameSender {
 public:
  virtual ~FrameSender() = default;
  virtual void send(Frame frame) = 0;
  virtual void close() = 0;
};

/// What is spoken with one client over its WebSocket. It is made when the client connects and
/// destroyed when it is gone. Every call comes from the server's thread and must not wait.
class SocketProtocol {
 public:
  virtual ~SocketProtocol() = default;
  virtual void on_text(std::string_view text) = 0;
  virtual void on_binary(std::string_view bytes) = 0;
};

/// A sub-protocol by its name, as in Sec-WebSocket-Protocol.
struct NamedProtocol {
  std::string name;
  std::function<std::unique_ptr<SocketProtocol>(std::shared_ptr<FrameSender>)> connect;
};

}  // namespace echomap::live_page
