// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/live_page/command_handler.hpp"
#include "host/live_page/history.hpp"
#include "host/live_page/socket_protocol.hpp"

namespace echomap::live_page {

/// Those that see a run by echomap.v1 and tell it what to do. All calls come from one thread, but
/// for `driver` and `set_can`.
class LiveClients {
 public:
  using TakeCommand = std::function<void(const session::OperatorCommand&)>;

  /// `history` of the run that they see; null: of none.
  LiveClients(CommandHandler handler, std::shared_ptr<History> history, TakeCommand take_command);

  /// Tells the client its number and what there is by now.
  std::uint64_t join(std::shared_ptr<FrameSender> sender);
  void leave(std::uint64_t client);
  /// Answers by a frame.
  void take_text(std::uint64_t client, std::string_view text);
  /// Takes the command of one who has no socket.
  CommandHandler::Answer take_post(std::string_view text);
  /// Sends the message to all.
  void send(const Frame& frame);
  /// From now on nobody's command is passed on.
  void stop_listening();

  /// Safe from every thread, as is the next one.
  std::optional<CommandHandler::Driver> driver() const;
  /// From now on the run takes these commands.
  void set_can(std::vector<std::string> can);

  /// A message on its way to a client.
  static Frame frame_of(const SharedMessage& message);

 private:
  CommandHandler::Answer answer(std::uint64_t client, std::string_view text);

  mutable std::mutex handler_mutex_;
  CommandHandler handler_;
  std::shared_ptr<History> history_;
  TakeCommand take_command_;
  std::map<std::uint64_t, std::shared_ptr<FrameSender>> clients_;
  std::uint64_t next_client_ = CommandHandler::kPostingClient + 1;
};

/// echomap.v1 with one client (docs/live_protocol.md).
NamedProtocol echomap_protocol(LiveClients& clients);

}  // namespace echomap::live_page
