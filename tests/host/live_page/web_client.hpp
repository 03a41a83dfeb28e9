// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace echomap::live_page {

/// What a server answers to an HTTP request.
struct HttpReply {
  int status = 0;                              ///< 0: the connection ended without an answer.
  std::map<std::string, std::string> headers;  ///< Names in lower case.
  std::string body;
};

/// One TCP connection to a server on the loopback, by the system's calls alone.
class WebClient {
 public:
  /// `receive_buffer` in bytes; 0: the system's.
  explicit WebClient(std::uint16_t port, int receive_buffer = 0);
  ~WebClient();
  WebClient(WebClient&& other) noexcept;
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  void send(const std::string& bytes);
  /// Sends the text as it stands and reads the answer.
  HttpReply ask(const std::string& request, bool has_body = true);
  /// What comes in next; empty after `patience` or at the end.
  std::string receive(std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// Whether the server ends the connection within that time.
  bool ends_within(std::chrono::milliseconds patience);
  void close();

 protected:
  /// Exactly so many bytes; fewer at the end or after `patience`.
  std::string take(std::size_t count, std::chrono::milliseconds patience);

 private:
  int socket_ = -1;
  std::string received_;
};

/// A frame as a client sees it.
struct ReceivedFrame {
  unsigned opcode = 0;  ///< 1 text, 2 binary, 8 close, 9 ping.
  std::string bytes;
};

/// A client of a WebSocket.
class WebSocketClient : public WebClient {
 public:
  /// `headers` beside those that every request for a WebSocket has, each with its "\r\n".
  WebSocketClient(std::uint16_t port,
                  const std::string& protocol,
                  const std::string& headers = {},
                  const std::string& target = "/ws",
                  int receive_buffer = 0);

  const HttpReply& reply() const { return reply_; }
  bool is_open() const { return reply_.status == 101; }
  void send_frame(unsigned opcode, const std::string& bytes);
  void send_text(const std::string& text) { send_frame(1, text); }
  /// The next one that is no ping; nothing after that time or at the end.
  std::optional<ReceivedFrame> read(std::chrono::milliseconds patience = std::chrono::seconds(20));
  /// The next text, others left out; empty where none comes.
  std::string read_text(std::chrono::milliseconds patience = std::chrono::seconds(20));

 private:
  HttpReply reply_;
};

/// A request with the Host that the server expects.
std::string get(std::uint16_t port, const std::string& target, const std::string& headers = {});
std::string post(std::uint16_t port, const std::string& body, const std::string& headers = {});

}  // namespace echomap::live_page
