// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/live_page/served_run.hpp"
#include "host/live_page/socket_protocol.hpp"
#include "host/session/operator_command.hpp"

namespace echomap::live_page {

/// Where and to whom the page is served.
struct PageServerParams {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: any that is free.
  /// Demanded of every request where it is not empty.
  std::string token;
  /// The files of the page: index.html, app.js, app.css, favicon.svg.
  std::filesystem::path page_folder;
  /// The description of the REST interface.
  std::filesystem::path openapi_file;
  /// Commands that the live run takes: names of docs/live_protocol.md.
  std::vector<std::string> can;
  /// What /ws speaks beside echomap.v1.
  std::vector<NamedProtocol> protocols;
};

/// Who is connected, for the run's state.
struct PageAudience {
  std::size_t clients = 0;              ///< WebSockets, of every sub-protocol.
  std::optional<std::uint64_t> driver;  ///< Number of the client that holds the driver lock.
  std::string driver_name;
};

/// Serves the live page on one port, in a thread of its own (docs/live_protocol.md).
class PageServer {
 public:
  /// Takes commands in the server's thread; it must not wait.
  using TakeCommand = std::function<void(const session::OperatorCommand&)>;

  /// Listens when it returns. Throws console::CommandError where it cannot.
  PageServer(const PageServerParams& params, std::vector<ServedRun> runs, TakeCommand take_command);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// What to open in a browser, with the token where one is demanded.
  const std::string& url() const;
  PageAudience audience() const;
  /// From now on the live run takes these commands: names of docs/live_protocol.md.
  void set_can(std::vector<std::string> can);
  /// What went wrong in the server's thread since the last call, which must not log: a session
  /// records its log. Empty where nothing did.
  std::string take_trouble();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace echomap::live_page
