// SPDX-License-Identifier: MIT
#include "host/live_page/request_guard.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using Verdict = RequestGuard::Verdict;

RequestGuard guard_of(const std::string& address, const std::string& token = {}) {
  return {*IpLiteral::parse(address), 8080, token};
}

WebRequest asked(const std::string& host,
                 std::vector<std::pair<std::string, std::string>> headers = {}) {
  WebRequest request{"GET", "/", std::move(headers), {}};
  request.headers.emplace_back("host", host);
  return request;
}

WebRequest posted(const std::string& host, const std::string& origin) {
  WebRequest request = asked(host, {{"Origin", origin}});
  request.method = "POST";
  return request;
}

TEST(RequestGuard, LetsOnlyItsOwnHostsThrough) {
  const RequestGuard guard = guard_of("127.0.0.1");
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080", "[::1]:8080"}) {
    EXPECT_EQ(guard.judge(asked(host)), Verdict::kPass) << host;
  }
  for (const char* host : {"evil.example:8080",
                           "127.0.0.1",
                           "127.0.0.1:8081",
                           "192.168.1.5:8080",
                           "localhost.evil.example:8080",
                           "127.0.0.1:8080:8080",
                           "",
                           ":8080",
                           "127.1:8080",
                           "0x7f000001:8080",
                           "[::1",
                           "127.0.0.1:8080@evil.example",
                           "127.0.0.1:80808080808080"}) {
    EXPECT_EQ(guard.judge(asked(host)), Verdict::kForeignHost) << host;
  }
}

TEST(RequestGuard, RefusesARequestWithoutAHostOrWithTwo) {
  const RequestGuard guard = guard_of("127.0.0.1");
  EXPECT_EQ(guard.judge({"GET", "/", {}, {}}), Verdict::kForeignHost);
  EXPECT_EQ(guard.judge(asked("127.0.0.1:8080", {{"Host", "127.0.0.1:8080"}})),
            Verdict::kForeignHost);
}

TEST(RequestGuard, TakesEveryNumberButNoNameOnEveryAddress) {
  for (const char* address : {"0.0.0.0", "::"}) {
    const RequestGuard guard = guard_of(address);
    EXPECT_EQ(guard.judge(asked("192.168.1.5:8080")), Verdict::kPass);
    EXPECT_EQ(guard.judge(asked("[fe80::1]:8080")), Verdict::kPass);
    EXPECT_EQ(guard.judge(asked("localhost:8080")), Verdict::kPass);
    EXPECT_EQ(guard.judge(asked("robot.local:8080")), Verdict::kForeignHost);
  }
  const RequestGuard one = guard_of("192.168.1.5");
  EXPECT_EQ(one.judge(asked("192.168.1.5:8080")), Verdict::kPass);
  EXPECT_EQ(one.judge(asked("192.168.1.6:8080")), Verdict::kForeignHost);
}

TEST(RequestGuard, RefusesWhatPagesOfOthersSend) {
  const RequestGuard guard = guard_of("127.0.0.1");
  EXPECT_EQ(guard.judge(posted("127.0.0.1:8080", "http://127.0.0.1:8080")), Verdict::kPass);
  for (const char* origin : {"http://evil.example",
                             "http://127.0.0.1:8081",
                             "http://127.0.0.1",
                             "http://localhost:8080",
                             "null",
                             "",
                             "https://127.0.0.1:8080",
                             "file://",
                             "http://127.0.0.1:8080.evil.example"}) {
    EXPECT_EQ(guard.judge(posted("127.0.0.1:8080", origin)), Verdict::kForeignOrigin) << origin;
  }
}

TEST(RequestGuard, ChecksTheOriginOfWebSocketsButNotOfPlainReads) {
  const RequestGuard guard = guard_of("127.0.0.1");
  WebRequest request = asked("127.0.0.1:8080", {{"Origin", "http://evil.example"}});
  EXPECT_EQ(guard.judge(request), Verdict::kPass);
  request.is_upgrade = true;
  EXPECT_EQ(guard.judge(request), Verdict::kForeignOrigin);
  WebRequest program = asked("127.0.0.1:8080");
  program.is_upgrade = true;
  EXPECT_EQ(guard.judge(program), Verdict::kPass) << "no browser";
}

TEST(RequestGuard, KnowsTheStandardPort) {
  const RequestGuard guard(*IpLiteral::parse("127.0.0.1"), 80, {});
  EXPECT_EQ(guard.judge(posted("127.0.0.1", "http://127.0.0.1")), Verdict::kPass);
  EXPECT_EQ(guard.judge(posted("127.0.0.1:80", "http://127.0.0.1")), Verdict::kPass);
}

TEST(RequestGuard, DemandsItsTokenAndAnswersItByACookie) {
  const RequestGuard guard = guard_of("127.0.0.1", "s3cret");
  WebRequest request = asked("127.0.0.1:8080");
  EXPECT_EQ(guard.judge(request), Verdict::kNoToken);
  EXPECT_EQ(guard.cookie_for(request), "");
  request.target = "/?token=wrong";
  EXPECT_EQ(guard.judge(request), Verdict::kNoToken);
  EXPECT_EQ(guard.cookie_for(request), "");
  request.target = "/?x=1&token=s3cret";
  EXPECT_EQ(guard.judge(request), Verdict::kPass);
  EXPECT_EQ(guard.cookie_for(request), "echomap_8080=s3cret; Path=/; HttpOnly; SameSite=Strict");
}

TEST(RequestGuard, TakesTheCookieForTheToken) {
  const RequestGuard guard = guard_of("127.0.0.1", "s3cret");
  const auto judged = [&](const char* cookie) {
    return guard.judge(asked("127.0.0.1:8080", {{"Cookie", cookie}}));
  };
  EXPECT_EQ(judged("echomap_8080=s3cret"), Verdict::kPass);
  EXPECT_EQ(judged("a=b; echomap_8080=s3cret;c=d"), Verdict::kPass);
  EXPECT_EQ(judged("echomap_8081=s3cret"), Verdict::kNoToken);
  EXPECT_EQ(judged("echomap_8080=s3cre"), Verdict::kNoToken);
  EXPECT_EQ(judged("echomap_8080=s3cret2"), Verdict::kNoToken);
  EXPECT_EQ(judged("echomap_8080="), Verdict::kNoToken);
}

TEST(RequestGuard, ComparesSecretsWhole) {
  EXPECT_TRUE(is_same_secret("abc", "abc"));
  EXPECT_FALSE(is_same_secret("abd", "abc"));
  EXPECT_FALSE(is_same_secret("abcabc", "abc"));
  EXPECT_FALSE(is_same_secret("", "abc"));
  EXPECT_FALSE(is_same_secret("abc", ""));
  EXPECT_TRUE(is_same_secret("", ""));
}

}  // namespace
}  // namespace echomap::live_page
