// SPDX-License-Identifier: MIT
#include "host/live_page/http_connection.hpp"

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/live_page/request_parsing.hpp"
#include "tests/host/live_page/served_page.hpp"
#include "tests/host/live_page/web_client.hpp"

namespace echomap::live_page {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

int status_of(std::uint16_t port, const std::string& request) {
  return WebClient(port).ask(request).status;
}

TEST(HttpConnection, RefusesAHostThatIsNotItsOwn) {
  ServedPage page;
  const HttpReply reply =
      WebClient(page.port()).ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  EXPECT_EQ(reply.status, 403);
  EXPECT_THAT(reply.body, testing::Not(HasSubstr("index.html")));
}

TEST(HttpConnection, RefusesAPostFromAPageOfSomebodyElse) {
  ServedPage page;
  EXPECT_EQ(status_of(page.port(),
                      post(page.port(), R"({"do": "stop"})", "Origin: http://evil.example\r\n")),
            403);
  EXPECT_TRUE(page.commands().empty());
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(page.port()) + "\r\n";
  EXPECT_EQ(status_of(page.port(), post(page.port(), R"({"do": "stop"})", own)), 200);
}

TEST(HttpConnection, GivesTheTokensHolderACookieThatOpensTheRest) {
  PageServerParams params;
  params.token = "s3cret";
  ServedPage page(params);
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/")), 401);
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/?token=guess")), 401);
  EXPECT_EQ(status_of(page.port(), post(page.port(), R"({"do": "stop"})")), 401);
  const HttpReply reply = WebClient(page.port()).ask(get(page.port(), "/?token=s3cret"));
  EXPECT_EQ(reply.status, 200);
  const std::string cookie = reply.headers.at("set-cookie");
  const std::string pair = "Cookie: " + cookie.substr(0, cookie.find(';')) + "\r\n";
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/app.js", pair)), 200);
}

TEST(HttpConnection, RefusesWhatIsTooLarge) {
  ServedPage page;
  const std::string large_header = "X: " + std::string(16000, 'x') + "\r\n";
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/", large_header)), 431);
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/" + std::string(16000, 'x'))), 431);
  EXPECT_EQ(status_of(page.port(), post(page.port(), std::string(5000, ' '))), 413);
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/")), 200);
}

TEST(HttpConnection, RefusesWhatIsNoRequest) {
  ServedPage page;
  for (const char* text : {"\r\n\r\n\r\n",
                           "hello\r\n\r\n",
                           "GET\r\n\r\n",
                           "GET / HTTP/9.9\r\n\r\n",
                           "GET / HTTP/1.1\r\nHost\r\n\r\n",
                           "\x16\x03\x01\x02\x01\r\n\r\n"}) {
    EXPECT_EQ(status_of(page.port(), text), 400) << text;
  }
}

TEST(HttpConnection, StaysWithinTheRunsFolder) {
  ServedPage page;
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/api/v1/runs/0/files/map.png")), 200);
  for (const char* name : {"..%2fsecret", "../secret", "%2e%2e/secret", "..", "%2fetc%2fpasswd"}) {
    EXPECT_EQ(status_of(page.port(), get(page.port(), "/api/v1/runs/0/files/" + std::string(name))),
              404)
        << name;
  }
}

TEST(HttpConnection, SendsLongBodiesWhole) {
  ServedPage page;
  std::ofstream(page.folder() / "run" / "session.mcap") << std::string(3000000, 's');
  WebClient client(page.port());
  for (int i = 0; i < 2; ++i) {
    const HttpReply reply = client.ask(get(page.port(), "/api/v1/runs/0/files/session.mcap"));
    EXPECT_EQ(reply.body, std::string(3000000, 's'));
  }
  page.history().add(made_message(MessageKind::kEvent, 0, "event"));
  EXPECT_EQ(client.ask(get(page.port(), "/api/v1/runs/0/history")).body,
            std::string("\5\0\0\0event", 9));
}

TEST(HttpConnection, EndsAfterARequestThatSaysSo) {
  ServedPage page;
  WebClient client(page.port());
  EXPECT_EQ(client.ask(get(page.port(), "/", "Connection: close\r\n")).status, 200);
  EXPECT_TRUE(client.ends_within(5s));
}

TEST(HttpConnection, AnswersRequestsThatComeAtOnceOrByteByByte) {
  ServedPage page;
  WebClient client(page.port());
  const std::string request = get(page.port(), "/");
  EXPECT_EQ(client.ask(request + request).status, 200);
  EXPECT_EQ(client.ask("").status, 200);
  for (const char byte : request) {
    client.send(std::string(1, byte));
  }
  EXPECT_EQ(client.ask("").status, 200);
}

TEST(HttpConnection, IsNotHinderedByManyThatSayHalfOfARequest) {
  ServedPage page;
  std::vector<WebClient> slow;
  for (int i = 0; i < 200; ++i) {
    slow.emplace_back(page.port());
    slow.back().send("GET / HTTP/1.1\r\nHost: 12");
  }
  EXPECT_EQ(status_of(page.port(), get(page.port(), "/")), 200);
  EXPECT_TRUE(slow.front().ends_within(15s)) << "ten seconds are enough for a request";
  EXPECT_TRUE(slow.back().ends_within(5s));
}

TEST(ParseRequest, WaitsForTheWholeRequest) {
  const std::string text = "POST /a?b HTTP/1.1\r\nHost: h\r\nContent-Length: 2\r\n\r\nxy";
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_FALSE(parse_request(text.substr(0, length))) << length;
  }
  const auto parsed = parse_request(text);
  ASSERT_TRUE(parsed);
  const auto& request = std::get<WebRequest>(*parsed);
  EXPECT_EQ(request.method, "POST");
  EXPECT_EQ(request.target, "/a?b");
  EXPECT_EQ(request.value_of("host"), "h");
  EXPECT_EQ(request.body, "xy");
  EXPECT_FALSE(request.is_upgrade);
}

TEST(ParseRequest, SaysWhyItRefuses) {
  const auto status = [](const std::string& text) {
    return std::get<WebResponse>(*parse_request(text)).status;
  };
  EXPECT_EQ(status("hello\r\n\r\n"), 400U);
  EXPECT_EQ(status("GET / HTTP/1.1\r\nX: " + std::string(20000, 'x') + "\r\n\r\n"), 431U);
  EXPECT_EQ(status("POST / HTTP/1.1\r\nContent-Length: 5000\r\n\r\n"), 413U);
}

}  // namespace
}  // namespace echomap::live_page
