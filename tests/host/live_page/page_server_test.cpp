// SPDX-License-Identifier: MIT
#include "host/live_page/page_server.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "host/console/exit_code.hpp"
#include "host/live_page/server_clock.hpp"
#include "tests/host/live_page/served_page.hpp"
#include "tests/host/live_page/web_client.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/resident_memory.hpp"

namespace echomap::live_page {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using tests::eventually;

std::string drive_command(int seq, double forward, double seen_ms) {
  return R"({"do": "drive", "seq": )" + std::to_string(seq) + R"(, "forward": )" +
         std::to_string(forward) + R"(, "turn": 0, "seen": )" + std::to_string(seen_ms) + "}";
}

const session::StopRobot* as_stop(const std::vector<session::OperatorCommand>& commands) {
  return commands.empty() ? nullptr : std::get_if<session::StopRobot>(&commands.back());
}

TEST(PageServer, ServesThePageOnAFreePort) {
  ServedPage page;
  EXPECT_EQ(page.server().url(), "http://127.0.0.1:" + std::to_string(page.port()) + "/");
  const HttpReply reply = WebClient(page.port()).ask(get(page.port(), "/"));
  EXPECT_EQ(reply.status, 200);
  EXPECT_THAT(reply.body, HasSubstr("index.html"));
  EXPECT_THAT(reply.headers.at("content-security-policy"), HasSubstr("default-src 'self'"));
}

TEST(PageServer, AnswersRequestAfterRequestOnOneConnection) {
  ServedPage page;
  WebClient client(page.port());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(client.ask(get(page.port(), "/app.js")).status, 200);
    const std::string head = "HEAD / HTTP/1.1\r\nHost: localhost:" + std::to_string(page.port());
    EXPECT_EQ(client.ask(head + "\r\n\r\n", false).headers.at("content-length"), "1019");
  }
}

TEST(PageServer, TellsAClientItsNumberThenTheNewestThenWhatChanges) {
  ServedPage page;
  page.history().add(made_message(MessageKind::kTile, 1, "old tile"));
  page.history().add(made_message(MessageKind::kTile, 1, "tile"));
  page.history().add(made_message(MessageKind::kHello, 0, "hello"));
  WebSocketClient client(page.port(), "echomap.v1");
  ASSERT_TRUE(client.is_open());
  EXPECT_EQ(client.reply().headers.at("sec-websocket-protocol"), "echomap.v1");
  EXPECT_EQ(client.read()->bytes, R"({"client": 1})");
  const auto hello = client.read();
  EXPECT_EQ(hello->opcode, 2U);
  EXPECT_EQ(hello->bytes, "hello");
  EXPECT_EQ(client.read()->bytes, "tile");
  page.history().add(made_message(MessageKind::kEvent, 0, "event"));
  EXPECT_EQ(client.read()->bytes, "event");
}

TEST(PageServer, StopsTheRobotWhoeverAsks) {
  ServedPage page;
  const HttpReply reply =
      WebClient(page.port()).ask(post(page.port(), R"({"do": "stop", "seq": 7})"));
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.body, R"({"ack":7,"ok":true})");
  ASSERT_NE(as_stop(page.commands()), nullptr);
  EXPECT_EQ(as_stop(page.commands())->cause, session::StopRobot::Cause::kPressed);
}

TEST(PageServer, LetsOneClientDriveAndTellsTheOtherWho) {
  ServedPage page;
  WebSocketClient first(page.port(), "echomap.v1");
  WebSocketClient second(page.port(), "echomap.v1");
  first.read_text();
  second.read_text();
  first.send_text(R"({"do": "name", "seq": 1, "name": "phone"})");
  EXPECT_EQ(first.read_text(), R"({"ack":1,"ok":true})");
  first.send_text(drive_command(2, 0.5, server_clock_ms()));
  EXPECT_EQ(first.read_text(), R"({"ack":2,"ok":true})");
  second.send_text(drive_command(1, 0.5, server_clock_ms()));
  EXPECT_EQ(second.read_text(),
            R"({"ack":1,"ok":false,"why":"client 1 (phone) drives","code":"not-driver"})");
  const PageAudience audience = page.server().audience();
  EXPECT_EQ(audience.clients, 2U);
  EXPECT_EQ(audience.driver, 1U);
  EXPECT_EQ(audience.driver_name, "phone");
  EXPECT_EQ(page.commands().size(), 1U);
}

TEST(PageServer, RefusesToSteerByWhatIsOld) {
  ServedPage page;
  std::this_thread::sleep_for(500ms);
  WebSocketClient client(page.port(), "echomap.v1");
  client.read_text();
  client.send_text(drive_command(1, 0.5, server_clock_ms() - 450.0));
  EXPECT_THAT(client.read_text(), HasSubstr("\"code\":\"stale\""));
  EXPECT_TRUE(page.commands().empty());
}

TEST(PageServer, StopsTheRobotWhenItsDriverCloses) {
  ServedPage page;
  {
    WebSocketClient driver(page.port(), "echomap.v1");
    driver.read_text();
    driver.send_text(drive_command(1, 0.5, server_clock_ms()));
    driver.read_text();
  }
  ASSERT_TRUE(eventually([&] { return page.commands().size() == 2; }));
  ASSERT_NE(as_stop(page.commands()), nullptr);
  EXPECT_EQ(as_stop(page.commands())->cause, session::StopRobot::Cause::kDriverGone);
  EXPECT_FALSE(page.server().audience().driver);
}

TEST(PageServer, TakesNoCommandsOfARunThatHasEnded) {
  ServedPage page({}, false);
  const HttpReply reply = WebClient(page.port()).ask(post(page.port(), R"({"do": "stop"})"));
  EXPECT_EQ(reply.status, 409);
  EXPECT_THAT(reply.body, HasSubstr("not-possible"));
  EXPECT_TRUE(page.commands().empty());
}

TEST(PageServer, EndsQuicklyWithClientsConnected) {
  ServedPage page;
  WebSocketClient watcher(page.port(), "echomap.v1");
  WebClient silent(page.port());
  silent.send("GET / HT");
  watcher.read_text();
  const auto begin = std::chrono::steady_clock::now();
  page.stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
  EXPECT_TRUE(watcher.ends_within(1s));
  page.history().add(made_message(MessageKind::kEvent, 0, "to nobody"));
}

TEST(PageServer, TakesMessagesFromAnotherThreadWhileClientsComeAndGo) {
  ServedPage page;
  std::thread run([&] {
    for (int i = 0; i < 2000; ++i) {
      page.history().add(made_message(MessageKind::kTile, i % 50, std::string(4112, 't')));
      page.history().add(made_message(MessageKind::kMotion, 0, "m"));
      page.server().audience();
    }
  });
  for (int i = 0; i < 20; ++i) {
    WebSocketClient client(page.port(), "echomap.v1");
    EXPECT_EQ(client.read()->opcode, 1U);
    EXPECT_TRUE(client.read());
  }
  run.join();
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 0; }));
}

TEST(PageServer, SendsASlowClientOnlyTheNewest) {
  ServedPage page;
  WebSocketClient slow(page.port(), "echomap.v1", "", "/ws", 4096);
  ASSERT_EQ(slow.read()->opcode, 1U);
  for (int i = 0; i < 20000; ++i) {
    page.history().add(
        made_message(MessageKind::kState, 0, std::to_string(i) + std::string(8000, ' ')));
    if (i % 100 == 0) {
      std::this_thread::sleep_for(1ms);
    }
  }
  page.history().add(made_message(MessageKind::kEvent, 0, "end"));
  std::size_t count = 0;
  std::string last;
  while (const auto frame = slow.read()) {
    if (frame->bytes == "end") {
      break;
    }
    ++count;
    last = frame->bytes;
  }
  EXPECT_EQ(last.substr(0, 6), "19999 ");
  EXPECT_LT(count, 200U);
}

TEST(PageServer, ClosesAClientThatDoesNotReadWhatMustNotBeLeftOut) {
  ServedPage page;
  WebSocketClient client(page.port(), "echomap.v1", "", "/ws", 4096);
  ASSERT_EQ(client.read()->opcode, 1U);
  WebSocketClient other(page.port(), "echomap.v1");
  other.read();
  for (int i = 0; i < 300; ++i) {
    page.history().add(made_message(MessageKind::kEvent, 0, std::string(8000, 'e')));
    other.read();
  }
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 1; }));
}

TEST(PageServer, RefusesAnAddressForOthersWithoutAToken) {
  PageServerParams params;
  params.address = "0.0.0.0";
  EXPECT_THROW(PageServer(params, {}, nullptr), console::CommandError);
}

TEST(PageServer, SaysWhereItCannotListen) {
  ServedPage page;
  PageServerParams params;
  params.port = page.port();
  try {
    PageServer(params, {}, nullptr);
    FAIL() << "two listen on one port";
  } catch (const console::CommandError& error) {
    EXPECT_THAT(error.what(), HasSubstr("in use"));
  }
}

/// A test of a thousand clients needs two thousand descriptors.
bool raise_descriptor_limit(rlim_t count) {
  rlimit limit{};
  ::getrlimit(RLIMIT_NOFILE, &limit);
  if (limit.rlim_cur >= count) {
    return true;
  }
  limit.rlim_cur = count;
  return limit.rlim_max >= count && ::setrlimit(RLIMIT_NOFILE, &limit) == 0;
}

TEST(PageServer, CarriesAThousandIdleClients) {
  if (!raise_descriptor_limit(4000)) {
    GTEST_SKIP() << "too few descriptors";
  }
  ServedPage page;
  // What fits into the system's buffers, for clients that read nothing.
  for (int i = 0; i < 10; ++i) {
    page.history().add(made_message(MessageKind::kTile, i, std::string(4112, 't')));
  }
  std::vector<std::unique_ptr<WebSocketClient>> clients;
  const double before_mb = tests::resident_mb();
  for (int i = 0; i < 1000; ++i) {
    clients.push_back(std::make_unique<WebSocketClient>(page.port(), "echomap.v1"));
    ASSERT_TRUE(clients.back()->is_open()) << i;
  }
  EXPECT_TRUE(eventually([&] { return page.server().audience().clients == 1000; }));
  const double grown_mb = tests::resident_mb() - before_mb;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(WebClient(page.port()).ask(get(page.port(), "/")).status, 200);
  const auto took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took, 1s);
  EXPECT_LT(grown_mb, 50.0);
  RecordProperty("grown_mb", std::to_string(grown_mb));
}

}  // namespace
}  // namespace echomap::live_page
