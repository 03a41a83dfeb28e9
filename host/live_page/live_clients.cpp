// SPDX-License-Identifier: MIT
#include "host/live_page/live_clients.hpp"

#include <utility>

namespace echomap::live_page {
namespace {

/// A client is one of those from its first moment to its last.
class EchomapProtocol final : public SocketProtocol {
 public:
  EchomapProtocol(LiveClients& clients, std::shared_ptr<FrameSender> sender)
      : clients_(clients), number_(clients.join(std::move(sender))) {}
  ~EchomapProtocol() override { clients_.leave(number_); }
  EchomapProtocol(const EchomapProtocol&) = delete;
  EchomapProtocol& operator=(const EchomapProtocol&) = delete;

  void on_text(std::string_view text) override { clients_.take_text(number_, text); }
  /// Commands are texts: the answer to anything else is that it is none.
  void on_binary(std::string_view) override { clients_.take_text(number_, {}); }

 private:
  LiveClients& clients_;
  std::uint64_t number_;
};

}  // namespace

LiveClients::LiveClients(CommandHandler handler,
                         std::shared_ptr<History> history,
                         TakeCommand take_command)
    : handler_(std::move(handler)),
      history_(std::move(history)),
      take_command_(std::move(take_command)) {}

std::uint64_t LiveClients::join(std::shared_ptr<FrameSender> sender) {
  const std::uint64_t number = next_client_++;
  sender->send(text_frame("{\"client\": " + std::to_string(number) + "}"));
  if (history_) {
    for (const SharedMessage& message : history_->newest()) {
      sender->send(frame_of(message));
    }
  }
  clients_[number] = std::move(sender);
  return number;
}

void LiveClients::leave(std::uint64_t client) {
  clients_.erase(client);
  std::optional<session::OperatorCommand> command;
  {
    const std::lock_guard lock(handler_mutex_);
    command = handler_.close(client);
  }
  if (command && take_command_) {
    take_command_(*command);
  }
}

void LiveClients::take_text(std::uint64_t client, std::string_view text) {
  const auto found = clients_.find(client);
  if (found != clients_.end()) {
    found->second->send(text_frame(answer(client, text).text));
  }
}

CommandHandler::Answer LiveClients::take_post(std::string_view text) {
  return answer(CommandHandler::kPostingClient, text);
}

void LiveClients::send(const Frame& frame) {
  for (const auto& [number, sender] : clients_) {
    sender->send(frame);
  }
}

void LiveClients::stop_listening() { take_command_ = nullptr; }

std::optional<CommandHandler::Driver> LiveClients::driver() const {
  const std::lock_guard lock(handler_mutex_);
  return handler_.driver();
}

void LiveClients::set_can(std::vector<std::string> can) {
  const std::lock_guard lock(handler_mutex_);
  handler_.set_can(std::move(can));
}

Frame LiveClients::frame_of(const SharedMessage& message) {
  Frame frame{{message, &message->bytes}, false, {}};
  if (message->is_state()) {
    frame.channel = FrameChannel{static_cast<std::uint64_t>(message->kind), message->key};
  }
  return frame;
}

CommandHandler::Answer LiveClients::answer(std::uint64_t client, std::string_view text) {
  CommandHandler::Answer answer;
  {
    const std::lock_guard lock(handler_mutex_);
    answer = handler_.answer(client, text);
  }
  if (answer.command && take_command_) {
    take_command_(*answer.command);
  }
  return answer;
}

NamedProtocol echomap_protocol(LiveClients& clients) {
  return {"echomap.v1", [&clients](std::shared_ptr<FrameSender> sender) {
            return std::make_unique<EchomapProtocol>(clients, std::move(sender));
          }};
}

}  // namespace echomap::live_page
