// SPDX-License-Identifier: MIT
#include "host/live_page/web_socket_connection.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include <boost/asio/post.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/src.hpp>
#include <boost/beast/websocket.hpp>

#include "host/live_page/queued_sender.hpp"

namespace echomap::live_page {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using SteadyTime = std::chrono::steady_clock::time_point;

constexpr std::size_t kMaxFrameBytes = std::size_t{16} << 10;
constexpr std::chrono::seconds kHandshakePatience{10};
/// Without a sign of life; it is asked for one after half of that.
constexpr std::chrono::seconds kIdlePatience{20};
/// What waits there is old already when the client gets it.
constexpr int kSendBufferBytes = 64 << 10;

void prepare(websocket::stream<beast::tcp_stream>& stream, const std::string& protocol) {
  stream.next_layer().expires_never();
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = kHandshakePatience;
  timeout.idle_timeout = kIdlePatience;
  timeout.keep_alive_pings = true;
  stream.set_option(timeout);
  stream.set_option(
      websocket::stream_base::decorator([protocol](websocket::response_type& response) {
        response.set(beast::http::field::sec_websocket_protocol, protocol);
      }));
  stream.read_message_max(kMaxFrameBytes);
  stream.auto_fragment(false);
  beast::error_code ignored;
  tcp::socket& socket = stream.next_layer().socket();
  socket.set_option(asio::socket_base::send_buffer_size(kSendBufferBytes), ignored);
}

/// One write at a time, while frames wait; every pending operation keeps it alive.
class WebSocketConnection final : public Connection,
                                  public std::enable_shared_from_this<WebSocketConnection> {
 public:
  WebSocketConnection(beast::tcp_stream stream, const NamedProtocol& protocol, ServerParts& parts)
      : stream_(std::move(stream)), protocol_(protocol), parts_(parts) {
    prepare(stream_, protocol.name);
  }
  ~WebSocketConnection() override { end(); }
  WebSocketConnection(const WebSocketConnection&) = delete;
  WebSocketConnection& operator=(const WebSocketConnection&) = delete;

  void start(BeastRequest request) {
    place_ = parts_.connections.add(weak_from_this());
    request_ = std::make_unique<BeastRequest>(std::move(request));
    stream_.async_accept(*request_, [self = shared_from_this()](beast::error_code error) {
      self->request_.reset();
      if (!error && !self->is_closed_) {
        self->open();
      }
    });
  }

  void close() override { end(); }
  SteadyTime blocked_since() const override { return write_start_; }

 private:
  void end() {
    is_closed_ = true;
    if (sender_) {
      sender_->detach();
      sender_.reset();
      --parts_.sockets;
    }
    session_.reset();
    beast::get_lowest_layer(stream_).close();
  }

  void open() {
    ++parts_.sockets;
    const auto wake = [weak = weak_from_this(), executor = stream_.get_executor()] {
      asio::post(executor, [weak] {
        if (const auto self = weak.lock()) {
          self->write();
        }
      });
    };
    sender_ = std::make_shared<QueuedSender>(wake);
    session_ = protocol_.connect(sender_);
    read();
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      self->take(error);
    });
  }

  void take(beast::error_code error) {
    if (error || is_closed_) {
      end();
      return;
    }
    const auto bytes = buffer_.cdata();
    const std::string_view frame(static_cast<const char*>(bytes.data()), bytes.size());
    stream_.got_text() ? session_->on_text(frame) : session_->on_binary(frame);
    buffer_.clear();
    read();
  }

  void write() {
    if (!is_closed_ && sender_->is_closed()) {
      end();
    }
    if (is_closed_ || frame_) {
      return;
    }
    frame_ = sender_->take();
    if (!frame_) {
      return;
    }
    write_start_ = std::chrono::steady_clock::now();
    stream_.text(frame_->is_text);
    stream_.async_write(
        asio::buffer(*frame_->bytes),
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->go_on(error); });
  }

  void go_on(beast::error_code error) {
    frame_.reset();
    write_start_ = SteadyTime::max();
    if (error) {
      end();
      return;
    }
    write();
  }

  websocket::stream<beast::tcp_stream> stream_;
  const NamedProtocol& protocol_;
  ServerParts& parts_;
  ConnectionList::Place place_;
  std::unique_ptr<BeastRequest> request_;
  beast::flat_buffer buffer_;
  std::shared_ptr<QueuedSender> sender_;
  std::unique_ptr<SocketProtocol> session_;
  std::optional<Frame> frame_;  ///< On its way.
  SteadyTime write_start_ = SteadyTime::max();
  bool is_closed_ = false;
};

}  // namespace

void serve_web_socket(beast::tcp_stream stream,
                      BeastRequest request,
                      const std::string& protocol,
                      ServerParts& parts) {
  const auto found = std::find_if(parts.protocols.begin(),
                                  parts.protocols.end(),
                                  [&](const NamedProtocol& each) { return each.name == protocol; });
  if (found != parts.protocols.end()) {
    std::make_shared<WebSocketConnection>(std::move(stream), *found, parts)
        ->start(std::move(request));
  }
}

}  // namespace echomap::live_page
