// SPDX-License-Identifier: MIT
#include "host/live_page/http_connection.hpp"

#include <array>
#include <chrono>
#include <utility>

#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "host/live_page/beast_request.hpp"
#include "host/live_page/request_parsing.hpp"
#include "host/live_page/web_socket_connection.hpp"

namespace echomap::live_page {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;

constexpr std::chrono::seconds kRequestPatience{10};
constexpr std::chrono::seconds kPartPatience{20};  ///< Of 64 KiB.
constexpr std::chrono::seconds kLingerPatience{1};
constexpr std::size_t kMaxLingerBytes = std::size_t{256} << 10;

/// Requests one after the other; every pending operation keeps it alive.
class HttpConnection final : public Connection,
                             public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(tcp::socket socket, ServerParts& parts)
      : stream_(std::move(socket)), parts_(parts), buffer_(kMaxHeaderBytes) {}

  void start() {
    place_ = parts_.connections.add(weak_from_this());
    read();
  }
  void close() override { stream_.close(); }
  /// Beast's timeouts watch this one.
  std::chrono::steady_clock::time_point blocked_since() const override {
    return std::chrono::steady_clock::time_point::max();
  }

 private:
  void read() {
    parser_ = std::make_unique<BeastRequestParser>();
    set_limits(*parser_);
    stream_.expires_after(kRequestPatience);
    http::async_read(
        stream_,
        buffer_,
        *parser_,
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->take(error); });
  }

  void take(beast::error_code error) {
    if (error == http::error::end_of_stream || error == beast::error::timeout ||
        error == asio::error::operation_aborted) {
      return;
    }
    if (error) {
      respond(refusal_of(error), false);
      return;
    }
    const BeastRequest& request = parser_->get();
    auto answer = parts_.router->answer(web_request_of(request));
    if (const auto* upgrade = std::get_if<SocketUpgrade>(&answer)) {
      become_socket(upgrade->protocol);
      return;
    }
    respond(std::move(std::get<WebResponse>(answer)), request.keep_alive());
  }

  void become_socket(const std::string& protocol) {
    place_.reset();
    serve_web_socket(std::move(stream_), parser_->release(), protocol, parts_);
  }

  void respond(WebResponse response, bool keep_alive) {
    response_ = std::move(response);
    keep_alive_ = keep_alive;
    head_ = head_of(response_, keep_alive);
    const bool has_text = response_.has_body && response_.body;
    const std::array<asio::const_buffer, 2> parts{
        asio::buffer(head_), has_text ? asio::buffer(*response_.body) : asio::const_buffer()};
    write(parts);
  }

  template <typename Buffers>
  void write(const Buffers& buffers) {
    stream_.expires_after(kPartPatience);
    asio::async_write(
        stream_, buffers, [self = shared_from_this()](beast::error_code error, std::size_t) {
          self->go_on(error);
        });
  }

  void go_on(beast::error_code error) {
    if (error) {
      return;
    }
    if (response_.has_body && response_.source) {
      part_ = response_.source->next_part();
      sent_ += part_.size();
      if (!part_.empty()) {
        write(asio::buffer(part_));
        return;
      }
      keep_alive_ = keep_alive_ && sent_ == response_.source->size();
    }
    finish();
  }

  void finish() {
    response_ = {};
    sent_ = 0;
    if (keep_alive_) {
      read();
      return;
    }
    beast::error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    buffer_.clear();
    stream_.expires_after(kLingerPatience);
    linger(0);
  }

  /// Bytes that nobody has read would make the system throw the response away with them.
  void linger(std::size_t read_bytes) {
    if (read_bytes > kMaxLingerBytes) {
      return;
    }
    stream_.async_read_some(
        buffer_.prepare(kMaxHeaderBytes),
        [self = shared_from_this(), read_bytes](beast::error_code error, std::size_t count) {
          if (!error) {
            self->linger(read_bytes + count);
          }
        });
  }

  beast::tcp_stream stream_;
  ServerParts& parts_;
  beast::flat_buffer buffer_;
  std::unique_ptr<BeastRequestParser> parser_;
  ConnectionList::Place place_;
  WebResponse response_;
  std::string head_;
  std::string part_;
  std::uint64_t sent_ = 0;
  bool keep_alive_ = false;
};

}  // namespace

WebRequest web_request_of(const BeastRequest& request) {
  const auto text = [](beast::string_view view) { return std::string(view.data(), view.size()); };
  WebRequest result{text(request.method_string()), text(request.target()), {}, request.body()};
  for (const auto& field : request) {
    result.headers.emplace_back(text(field.name_string()), text(field.value()));
  }
  result.is_upgrade = beast::websocket::is_upgrade(request);
  return result;
}

WebResponse refusal_of(beast::error_code error) {
  if (error == http::error::body_limit) {
    return text_response(413, "the request's body is too large");
  }
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return text_response(431, "the request's header is too large");
  }
  return text_response(400, "this is no HTTP request");
}

void set_limits(BeastRequestParser& parser) {
  parser.header_limit(kMaxHeaderBytes);
  parser.body_limit(kMaxBodyBytes);
}

std::optional<std::variant<WebRequest, WebResponse>> parse_request(std::string_view bytes) {
  BeastRequestParser parser;
  set_limits(parser);
  parser.eager(true);
  while (!parser.is_done()) {
    beast::error_code error;
    bytes.remove_prefix(parser.put(asio::buffer(bytes), error));
    if (error == http::error::need_more || (!error && bytes.empty() && !parser.is_done())) {
      return std::nullopt;
    }
    if (error) {
      return refusal_of(error);
    }
  }
  return web_request_of(parser.get());
}

void serve_http(tcp::socket socket, ServerParts& parts) {
  std::make_shared<HttpConnection>(std::move(socket), parts)->start();
}

}  // namespace echomap::live_page
