// SPDX-License-Identifier: MIT
#include "host/live_page/web_request.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(WebRequest, FindsHeadersWithoutRegardToCase) {
  const WebRequest request{"GET", "/", {{"HOST", "a"}, {"X", "1"}, {"x", "2"}}, {}};
  EXPECT_EQ(request.value_of("Host"), "a");
  EXPECT_THAT(request.values_of("x"), ElementsAre("1", "2"));
  EXPECT_EQ(request.value_of("x"), std::nullopt);
  EXPECT_THAT(request.values_of("y"), IsEmpty());
}

TEST(WebRequest, TakesItsTargetApart) {
  const WebRequest request{"GET", "/a/b?x=1&token=a%2Bb&y&z=%4", {}, {}};
  EXPECT_EQ(request.path(), "/a/b");
  EXPECT_EQ(request.query_value("x"), "1");
  EXPECT_EQ(request.query_value("token"), "a+b");
  EXPECT_EQ(request.query_value("y"), std::nullopt);
  EXPECT_EQ(request.query_value("z"), std::nullopt);
  EXPECT_EQ((WebRequest{"GET", "/a", {}, {}}).query_value("x"), std::nullopt);
}

TEST(WebRequest, ReadsLists) {
  EXPECT_THAT(elements_of(" a,b ,, c\t", ','), ElementsAre("a", "b", "c"));
  EXPECT_THAT(elements_of("", ','), IsEmpty());
  EXPECT_THAT(elements_of(" , ", ','), IsEmpty());
}

TEST(WebRequest, DecodesPercents) {
  EXPECT_EQ(percent_decoded("a%20b%2fc"), "a b/c");
  EXPECT_EQ(percent_decoded("%00"), std::string(1, '\0'));
  for (const char* text : {"%", "%1", "%1g", "%g1", "a%", "% 1", "%-1"}) {
    EXPECT_EQ(percent_decoded(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace echomap::live_page
