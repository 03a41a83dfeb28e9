// SPDX-License-Identifier: MIT
#include "tests/host/live_page/web_client.hpp"

#include <algorithm>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <unistd.h>
#include <utility>

#include <arpa/inet.h>
#include <sys/socket.h>

#include "host/live_page/web_request.hpp"

namespace echomap::live_page {
namespace {

using std::chrono::milliseconds;
constexpr std::chrono::seconds kPatience{20};

HttpReply read_head(const std::string& head) {
  HttpReply reply;
  std::istringstream lines(head);
  std::string version;
  lines >> version >> reply.status;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line != "\r") {
    const std::size_t colon = line.find(": ");
    reply.headers[lower_case(line.substr(0, colon))] =
        line.substr(colon + 2, line.size() - colon - 3);
  }
  return reply;
}

}  // namespace

WebClient::WebClient(std::uint16_t port, int receive_buffer)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_buffer > 0) {
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  }
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error("nobody listens on port " + std::to_string(port));
  }
}

WebClient::~WebClient() { close(); }

WebClient::WebClient(WebClient&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), received_(std::move(other.received_)) {}

void WebClient::close() {
  if (socket_ >= 0) {
    ::close(std::exchange(socket_, -1));
  }
}

void WebClient::send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) {
      return;
    }
    sent += static_cast<std::size_t>(count);
  }
}

std::string WebClient::receive(milliseconds patience) {
  if (!received_.empty()) {
    return std::exchange(received_, {});
  }
  pollfd wait{socket_, POLLIN, 0};
  if (::poll(&wait, 1, static_cast<int>(patience.count())) <= 0) {
    return {};
  }
  std::string bytes(std::size_t{64} << 10, '\0');
  const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
  bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  return bytes;
}

bool WebClient::ends_within(milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    pollfd wait{socket_, POLLIN, 0};
    if (::poll(&wait, 1, 20) > 0) {
      char bytes[4096];
      if (::recv(socket_, bytes, sizeof bytes, 0) <= 0) {
        return true;
      }
    }
  }
  return false;
}

std::string WebClient::take(std::size_t count, milliseconds patience) {
  while (received_.size() < count) {
    std::string before = std::exchange(received_, {});
    const std::string more = receive(patience);
    received_ = before + more;
    if (more.empty()) {
      break;
    }
  }
  std::string taken = received_.substr(0, count);
  received_.erase(0, taken.size());
  return taken;
}

HttpReply WebClient::ask(const std::string& request, bool has_body) {
  send(request);
  std::string head;
  while (head.find("\r\n\r\n") == std::string::npos) {
    const std::string next = take(1, kPatience);
    if (next.empty()) {
      return {};
    }
    head += next;
  }
  HttpReply reply = read_head(head);
  const auto length = reply.headers.find("content-length");
  if (has_body && length != reply.headers.end()) {
    reply.body = take(std::stoul(length->second), kPatience);
  }
  return reply;
}

WebSocketClient::WebSocketClient(std::uint16_t port,
                                 const std::string& protocol,
                                 const std::string& headers,
                                 const std::string& target,
                                 int receive_buffer)
    : WebClient(port, receive_buffer) {
  std::string offer =
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  if (!protocol.empty()) {
    offer += "Sec-WebSocket-Protocol: " + protocol + "\r\n";
  }
  reply_ = ask(get(port, target, offer + headers));
}

void WebSocketClient::send_frame(unsigned opcode, const std::string& bytes) {
  std::string frame{static_cast<char>(0x80U | opcode)};
  if (bytes.size() < 126) {
    frame += static_cast<char>(0x80U | bytes.size());
  } else {
    frame += static_cast<char>(0x80U | 126U);
    frame += static_cast<char>(bytes.size() >> 8U);
    frame += static_cast<char>(bytes.size() & 0xFFU);
  }
  send(frame + std::string(4, '\0') + bytes);  // A mask of zeros.
}

std::optional<ReceivedFrame> WebSocketClient::read(milliseconds patience) {
  const std::string head = take(2, patience);
  if (head.size() < 2) {
    return std::nullopt;
  }
  std::size_t length = static_cast<unsigned char>(head[1]);
  if (length >= 126) {
    const std::string digits = take(length == 126 ? 2 : 8, kPatience);
    length = 0;
    for (const char digit : digits) {
      length = length << 8U | static_cast<unsigned char>(digit);
    }
  }
  ReceivedFrame frame{static_cast<unsigned char>(head[0]) & 0xFU, take(length, kPatience)};
  return frame.opcode == 9 ? read(patience) : std::optional(frame);
}

std::string WebSocketClient::read_text(milliseconds patience) {
  while (auto frame = read(patience)) {
    if (frame->opcode == 1) {
      return frame->bytes;
    }
  }
  return {};
}

std::string get(std::uint16_t port, const std::string& target, const std::string& headers) {
  return "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" +
         headers + "\r\n";
}

std::string post(std::uint16_t port, const std::string& body, const std::string& headers) {
  return "POST /api/v1/commands HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
         "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" + headers + "\r\n" + body;
}

}  // namespace echomap::live_page
