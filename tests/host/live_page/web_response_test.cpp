// SPDX-License-Identifier: MIT
#include "host/live_page/web_response.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(WebResponse, BeginsWithItsStatusAndEndsWithAnEmptyLine) {
  const std::string head = head_of(text_response(404, "not there"), true);
  EXPECT_THAT(head, testing::StartsWith("HTTP/1.1 404 Not Found\r\n"));
  EXPECT_THAT(head, HasSubstr("Content-Length: 10\r\n"));
  EXPECT_THAT(head, testing::EndsWith("Connection: keep-alive\r\n\r\n"));
  EXPECT_THAT(head_of(text_response(404, ""), false), HasSubstr("Connection: close\r\n"));
}

TEST(WebResponse, KeepsBrowsersFromDoingMoreWithIt) {
  for (const unsigned status : {200U, 304U, 403U, 999U}) {
    const std::string head = head_of(json_response(status, "{}"), true);
    for (const char* header : {"Content-Security-Policy: default-src 'self'",
                               "frame-ancestors 'none'",
                               "X-Content-Type-Options: nosniff\r\n",
                               "Referrer-Policy: no-referrer\r\n",
                               "Cross-Origin-Resource-Policy: same-origin\r\n"}) {
      EXPECT_THAT(head, HasSubstr(header)) << status;
    }
  }
}

TEST(WebResponse, TellsNoLengthOfWhatHasNotChanged) {
  WebResponse response;
  response.status = 304;
  EXPECT_THAT(head_of(response, true), Not(HasSubstr("Content-Length")));
}

}  // namespace
}  // namespace echomap::live_page
