// SPDX-License-Identifier: MIT
#include "host/live_page/page_url.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"

namespace echomap::live_page {
namespace {

TEST(PageUrl, IsWhatABrowserTakes) {
  EXPECT_EQ(page_url(listen_address("127.0.0.1", ""), 8080, ""), "http://127.0.0.1:8080/");
  EXPECT_EQ(page_url(listen_address("localhost", ""), 8080, ""), "http://127.0.0.1:8080/");
  EXPECT_EQ(page_url(listen_address("::1", "t-1_A"), 80, "t-1_A"), "http://[::1]:80/?token=t-1_A");
}

TEST(PageUrl, NamesAnAddressOfAHostThatListensOnAll) {
  const std::string url = page_url(listen_address("0.0.0.0", "t"), 8080, "t");
  EXPECT_THAT(url, testing::MatchesRegex("http://[0-9.]+:8080/\\?token=t"));
  EXPECT_THAT(url, testing::Not(testing::HasSubstr("0.0.0.0")));
}

TEST(ListenAddress, DemandsATokenWhereOthersReachIt) {
  EXPECT_THROW(listen_address("0.0.0.0", ""), console::CommandError);
  EXPECT_THROW(listen_address("::", ""), console::CommandError);
  EXPECT_THROW(listen_address("192.168.1.5", ""), console::CommandError);
  EXPECT_EQ(listen_address("192.168.1.5", "t").number, "192.168.1.5");
}

TEST(ListenAddress, IsANumberAndItsTokenAWord) {
  EXPECT_THROW(listen_address("robot.local", "t"), console::CommandError);
  EXPECT_THROW(listen_address("", "t"), console::CommandError);
  EXPECT_THROW(listen_address("127.0.0.1", "a b"), console::CommandError);
  EXPECT_THROW(listen_address("127.0.0.1", "a;b"), console::CommandError);
}

}  // namespace
}  // namespace echomap::live_page
