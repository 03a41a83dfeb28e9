// SPDX-License-Identifier: MIT
#include "host/live_page/foxglove_protocol.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "host/live_page/foxglove_session.hpp"

namespace echomap::live_page {
namespace {

/// The first half of a FrameChannel: what may be replaced by its key, and what is one of its kind.
constexpr std::uint64_t kReplaceable = 0;
constexpr std::uint64_t kNeverReplaced = 1;

/// One client. Frames come from the server's thread, news from the run's.
class FoxgloveProtocol final : public SocketProtocol {
 public:
  FoxgloveProtocol(FoxgloveTopics& topics, std::shared_ptr<FrameSender> sender)
      : topics_(topics), sender_(std::move(sender)), session_(topics) {
    send(session_.begin());
    wake_up_ = topics_.listen([this] {
      const std::lock_guard lock(mutex_);
      send(session_.news());
    });
    const std::lock_guard lock(mutex_);
    send(session_.news());  // What came in between.
  }
  ~FoxgloveProtocol() override { topics_.unlisten(wake_up_); }
  FoxgloveProtocol(const FoxgloveProtocol&) = delete;
  FoxgloveProtocol& operator=(const FoxgloveProtocol&) = delete;

  void on_text(std::string_view text) override {
    const std::lock_guard lock(mutex_);
    send(session_.receive_text(text));
  }
  void on_binary(std::string_view bytes) override {
    const std::lock_guard lock(mutex_);
    send(session_.receive_binary(bytes));
  }

 private:
  struct Waiting {
    std::weak_ptr<const std::string> frame;  ///< Expired: it has been sent.
    std::size_t bytes = 0;
  };

  void send(FoxgloveSession::Frames frames) {
    for (FoxgloveFrame& frame : frames) {
      send(std::move(frame));
    }
  }
  void send(FoxgloveFrame frame);
  bool keeps_up();

  FoxgloveTopics& topics_;
  std::shared_ptr<FrameSender> sender_;
  std::mutex mutex_;
  FoxgloveSession session_;
  std::deque<Waiting> waiting_;  ///< Messages that may be left out and were not.
  std::size_t waiting_bytes_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t wake_up_ = 0;
};

void FoxgloveProtocol::send(FoxgloveFrame frame) {
  const auto bytes = std::make_shared<const std::string>(std::move(frame.bytes));
  Frame sent{bytes, frame.is_text, {}};
  if (frame.delivery == FoxgloveDelivery::kNewest) {
    sent.channel = FrameChannel{kReplaceable, frame.key};
  } else if (frame.delivery == FoxgloveDelivery::kLossy) {
    if (!keeps_up()) {
      return;
    }
    waiting_.push_back({bytes, bytes->size()});
    waiting_bytes_ += bytes->size();
    sent.channel = FrameChannel{kNeverReplaced, sent_++};
  }
  sender_->send(std::move(sent));
}

bool FoxgloveProtocol::keeps_up() {
  while (!waiting_.empty() && waiting_.front().frame.expired()) {
    waiting_bytes_ -= waiting_.front().bytes;
    waiting_.pop_front();
  }
  return waiting_bytes_ < kMaxWaitingFoxgloveBytes;
}

}  // namespace

std::vector<NamedProtocol> foxglove_protocols(FoxgloveTopics& topics) {
  std::vector<NamedProtocol> protocols;
  for (const std::string_view name : FoxgloveSession::kSubProtocols) {
    protocols.push_back({std::string(name), [&topics](std::shared_ptr<FrameSender> sender) {
                           return std::make_unique<FoxgloveProtocol>(topics, std::move(sender));
                         }});
  }
  return protocols;
}

}  // namespace echomap::live_page
