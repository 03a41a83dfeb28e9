// SPDX-License-Identifier: MIT
#include "host/live_page/web_socket_connection.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/live_page/served_page.hpp"
#include "tests/host/live_page/web_client.hpp"
#include "tests/support/eventually.hpp"

namespace echomap::live_page {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using tests::eventually;

/// Says everything back; "close" closes.
class EchoProtocol final : public SocketProtocol {
 public:
  explicit EchoProtocol(std::shared_ptr<FrameSender> sender) : sender_(std::move(sender)) {}

  void on_text(std::string_view text) override {
    if (text == "close") {
      sender_->close();
    }
    sender_->send(text_frame(std::string(text)));
  }
  void on_binary(std::string_view bytes) override {
    sender_->send({std::make_shared<const std::string>(bytes), false, {}});
  }

 private:
  std::shared_ptr<FrameSender> sender_;
};

NamedProtocol echo_protocol() {
  return {"echo.v1", [](std::shared_ptr<FrameSender> sender) {
            return std::make_unique<EchoProtocol>(std::move(sender));
          }};
}

PageServerParams with_echo() {
  PageServerParams params;
  params.protocols.push_back(echo_protocol());
  return params;
}

TEST(WebSocketConnection, SpeaksAProtocolThatIsPluggedIn) {
  ServedPage page(with_echo());
  WebSocketClient client(page.port(), "soap, echo.v1");
  ASSERT_TRUE(client.is_open());
  EXPECT_EQ(client.reply().headers.at("sec-websocket-protocol"), "echo.v1");
  EXPECT_EQ(client.reply().headers.at("sec-websocket-accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")
      << "RFC 6455, 1.3";
  client.send_text("text");
  client.send_frame(2, std::string("\0\1", 2));
  EXPECT_EQ(client.read()->opcode, 1U);
  const auto frame = client.read();
  EXPECT_EQ(frame->opcode, 2U);
  EXPECT_EQ(frame->bytes, std::string("\0\1", 2));
}

TEST(WebSocketConnection, EndsWhereItsProtocolSaysSo) {
  ServedPage page(with_echo());
  WebSocketClient client(page.port(), "echo.v1");
  client.send_text("close");
  EXPECT_TRUE(client.ends_within(5s));
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 0; }));
}

TEST(WebSocketConnection, RefusesAProtocolThatNobodySpeaks) {
  ServedPage page;
  EXPECT_EQ(WebSocketClient(page.port(), "echomap.v2").reply().status, 400);
  EXPECT_EQ(WebSocketClient(page.port(), "").reply().status, 400);
}

TEST(WebSocketConnection, RefusesPagesOfOthersButNoPrograms) {
  ServedPage page;
  const WebSocketClient foreign(page.port(), "echomap.v1", "Origin: http://evil.example\r\n");
  EXPECT_EQ(foreign.reply().status, 403);
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(page.port()) + "\r\n";
  EXPECT_TRUE(WebSocketClient(page.port(), "echomap.v1", own).is_open());
  EXPECT_TRUE(WebSocketClient(page.port(), "echomap.v1").is_open());
}

TEST(WebSocketConnection, DemandsTheToken) {
  PageServerParams params;
  params.token = "s3cret";
  ServedPage page(params);
  EXPECT_EQ(WebSocketClient(page.port(), "echomap.v1").reply().status, 401);
  EXPECT_TRUE(WebSocketClient(page.port(), "echomap.v1", "", "/ws?token=s3cret").is_open());
}

TEST(WebSocketConnection, ClosesAClientThatSendsTooMuchAtOnce) {
  ServedPage page;
  WebSocketClient client(page.port(), "echomap.v1");
  client.read();
  client.send_text(std::string(16000, ' '));
  EXPECT_THAT(client.read_text(), HasSubstr("malformed"));
  client.send_text(std::string(17000, ' '));
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 0; }));
}

TEST(WebSocketConnection, ClosesAClientThatBreaksTheRules) {
  ServedPage page;
  const std::string reserved_bits(20, '\xff');
  const std::string not_masked("\x81\x01x", 3);
  const std::string text_that_is_none("\x81\x82\0\0\0\0\xff\xff", 8);
  for (const std::string& bytes : {reserved_bits, not_masked, text_that_is_none}) {
    WebSocketClient client(page.port(), "echomap.v1");
    client.read();
    client.send(bytes);
    const auto frame = client.read();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->opcode, 8U);
  }
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 0; }));
}

TEST(WebSocketConnection, SendsFramesOfEveryLength) {
  ServedPage page;
  WebSocketClient client(page.port(), "echomap.v1");
  client.read();
  for (const std::size_t length : {1U, 125U, 126U, 65535U, 65536U, 300000U}) {
    const std::string bytes(length, 'b');
    page.history().add(made_message(MessageKind::kEvent, 0, bytes));
    EXPECT_EQ(client.read()->bytes, bytes);
  }
}

}  // namespace
}  // namespace echomap::live_page
