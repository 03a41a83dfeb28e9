// SPDX-License-Identifier: MIT
#include "host/apps/served_page.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <unistd.h>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "tests/host/apps/live_page_visit.hpp"
#include "tests/support/eventually.hpp"

namespace echomap::apps {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;
using testing::MatchesRegex;

LiveOptions page_at(const std::string& listen) { return {true, listen, false}; }

std::vector<live_page::ServedRun> one_run() {
  return {{"first_map", {}, std::make_shared<live_page::History>(), false}};
}

/// The page, without what it prints.
std::unique_ptr<live_page::PageServer> serve_silently(const std::string& listen) {
  testing::internal::CaptureStderr();
  auto server = serve_page(page_at(listen), one_run());
  testing::internal::GetCapturedStderr();
  return server;
}

std::string url_at(const std::string& listen) { return serve_silently(listen)->url(); }

/// Why nothing is served there; fails the test where something is.
console::CommandError error_at(const std::string& listen) {
  try {
    serve_page(page_at(listen), one_run());
  } catch (const console::CommandError& error) {
    return error;
  }
  ADD_FAILURE() << "serves at '" << listen << "'";
  return {ExitCode::kOk, ""};
}

TEST(ServedPage, IsAtTheAddressAndPortThatAreNamed) {
  const auto first = serve_silently("127.0.0.1:0");
  EXPECT_THAT(first->url(), MatchesRegex("http://127.0.0.1:[0-9]+/"));
  const std::string port = std::to_string(port_in(first->url()));
  EXPECT_EQ(url_at("127.0.0.2:" + port), "http://127.0.0.2:" + port + "/");
  EXPECT_THAT(url_at("localhost:0"), MatchesRegex("http://127.0.0.1:[0-9]+/"));
}

TEST(ServedPage, TakesAnAddressOfIpv6WithItsBrackets) {
  try {
    const auto server = serve_page(page_at("[::1]:0"), one_run());
    EXPECT_THAT(server->url(), MatchesRegex("http://\\[::1\\]:[0-9]+/"));
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), ExitCode::kRuntimeError) << "a host without IPv6: " << error.what();
  }
}

TEST(ServedPage, HasThePageItselfAndTheRuns) {
  const auto server = serve_silently("127.0.0.1:0");
  const std::uint16_t port = port_in(server->url());
  const auto page = live_page::WebClient(port).ask(live_page::get(port, "/"));
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(page.headers.at("content-type"), HasSubstr("text/html"));
  EXPECT_THAT(live_page::WebClient(port).ask(live_page::get(port, "/api/v1/runs")).body,
              HasSubstr("first_map"));
  EXPECT_THAT(live_page::WebClient(port).ask(live_page::get(port, "/api/v1/openapi.json")).body,
              HasSubstr("openapi"));
}

TEST(ServedPage, SaysWhereItIs) {
  testing::internal::CaptureStderr();
  const auto server = serve_page(page_at("127.0.0.1:0"), one_run());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "live page: " + server->url() + "\n");
}

TEST(ServedPage, RefusesWhatIsNoAddressAsAMistakeOfTheCommandLine) {
  for (const char* listen : {"127.0.0.1:",
                             "127.0.0.1:web",
                             "127.0.0.1:80x",
                             "127.0.0.1:70000",
                             "127.0.0.1:-1",
                             "127.0.0.1: 80",
                             "[::1]:",
                             ":8360",
                             "",
                             "here",
                             "here:80",
                             "[127.0.0.1",
                             "1.2.3:80"}) {
    const console::CommandError error = error_at(listen);
    EXPECT_EQ(error.code(), ExitCode::kUsage) << listen;
    EXPECT_THAT(error.what(), HasSubstr("\n  next: ")) << listen;
  }
  EXPECT_THAT(error_at("127.0.0.1:web").what(),
              HasSubstr("--listen 127.0.0.1:web: not an ADDRESS or ADDRESS:PORT"));
}

TEST(ServedPage, HasATokenWhereOthersReachItAndAlwaysAnotherOne) {
  const std::string url = url_at("0.0.0.0:0");
  EXPECT_THAT(url, MatchesRegex("http://[0-9.]+:[0-9]+/\\?token=[0-9a-f]+"));
  const std::string token = url.substr(url.find('=') + 1);
  EXPECT_EQ(token.size(), 32U);
  EXPECT_THAT(url_at("0.0.0.0:0"), testing::Not(HasSubstr(token)));
}

/// Whatever else runs here has the usual port, or this has.
class TakenPort {
 public:
  explicit TakenPort(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
      ::listen(socket_, 1);
    }
  }
  ~TakenPort() { ::close(socket_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;

 private:
  int socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

TEST(ServedPage, TakesAnotherPortWhereTheUsualOneIsTaken) {
  const TakenPort usual(8360);
  EXPECT_NE(port_in(url_at("127.0.0.1")), 8360);
}

TEST(ServedPage, TakesNoOtherPortThanTheOneThatIsNamed) {
  const auto server = serve_silently("127.0.0.1:0");
  const std::string taken = "127.0.0.1:" + std::to_string(port_in(server->url()));
  const console::CommandError error = error_at(taken);
  EXPECT_EQ(error.code(), ExitCode::kRuntimeError);
  EXPECT_THAT(error.what(), HasSubstr("cannot serve the live page on " + taken));
  EXPECT_THAT(error.what(), HasSubstr("next: name another port"));
}

TEST(WaitWhileWatched, ReturnsAtOnceWhereNobodyWatches) {
  const auto server = serve_silently("127.0.0.1:0");
  testing::internal::CaptureStderr();
  const auto begin = steady_clock::now();
  wait_while_watched(*server, std::chrono::minutes(5));
  EXPECT_LT(steady_clock::now() - begin, std::chrono::minutes(1));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(WaitWhileWatched, WaitsUntilTheLastPageIsClosed) {
  const auto server = serve_silently("127.0.0.1:0");
  auto page = std::make_unique<live_page::WebSocketClient>(port_in(server->url()), "echomap.v1");
  ASSERT_TRUE(tests::eventually([&] { return server->audience().clients == 1; }));
  std::thread person([&] {
    std::this_thread::sleep_for(milliseconds(200));
    page.reset();
  });
  testing::internal::CaptureStderr();
  const auto begin = steady_clock::now();
  wait_while_watched(*server, milliseconds(100));
  EXPECT_GE(steady_clock::now() - begin, milliseconds(200));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("the page stays at " + server->url() + " until it is closed"));
  person.join();
  EXPECT_EQ(server->audience().clients, 0U);
}

TEST(WaitWhileWatched, EndsByCtrlC) {
  const auto watch_and_interrupt = [] {
    const auto server = serve_page(page_at("127.0.0.1:0"), one_run());
    const live_page::WebSocketClient page(port_in(server->url()), "echomap.v1");
    const bool is_there = tests::eventually([&] { return server->audience().clients == 1; });
    console::catch_interrupts();
    std::raise(SIGINT);
    wait_while_watched(*server, std::chrono::minutes(5));
    wait_for_interrupt();
    std::_Exit(is_there ? 0 : 1);
  };
  EXPECT_EXIT(watch_and_interrupt(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace echomap::apps
