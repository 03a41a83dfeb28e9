// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/live_page/command_handler.hpp"
#include "host/live_page/page_assets.hpp"
#include "host/live_page/request_guard.hpp"
#include "host/live_page/served_run.hpp"
#include "host/live_page/web_request.hpp"
#include "host/live_page/web_response.hpp"

namespace echomap::live_page {

/// The request becomes a WebSocket that speaks this sub-protocol.
struct SocketUpgrade {
  std::string protocol;
};

/// What the router answers from.
struct PageContent {
  RequestGuard guard;
  PageAssets assets;
  std::string openapi;  ///< The description of the REST interface.
  std::vector<ServedRun> runs;
  std::vector<std::string> protocols;  ///< Of the WebSocket.
  std::function<CommandHandler::Answer(std::string_view)> take_command;
};

/// From a request to its response; knows nothing of sockets.
class PageRouter {
 public:
  using Answer = std::variant<WebResponse, SocketUpgrade>;

  explicit PageRouter(PageContent content) : content_(std::move(content)) {}

  /// Whatever the request is, there is an answer.
  Answer answer(const WebRequest& request) const;

  /// The paths of the REST interface with their methods, as in "GET /api/v1/runs/{id}/history".
  static std::vector<std::string> rest_paths();

 private:
  /// What stands in a path's braces.
  using Values = std::vector<std::string>;
  struct Route;

  static const std::vector<Route>& routes();
  Answer route(const WebRequest& request) const;
  Answer upgrade(const WebRequest& request) const;
  WebResponse rest_response(const WebRequest& request) const;
  WebResponse runs(const WebRequest& request, const Values& values) const;
  WebResponse history(const WebRequest& request, const Values& values) const;
  WebResponse files(const WebRequest& request, const Values& values) const;
  WebResponse file(const WebRequest& request, const Values& values) const;
  WebResponse command(const WebRequest& request, const Values& values) const;
  WebResponse openapi(const WebRequest& request, const Values& values) const;
  const ServedRun* run_of(const std::string& id) const;

  PageContent content_;
};

}  // namespace echomap::live_page
