// SPDX-License-Identifier: MIT
#include "host/fleet_messages/content_hash.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::fleet_messages {
namespace {

TEST(ContentHash, IsTheFirstHalfOfTheStandardsExample) {
  // FIPS 180-4's example of one block.
  EXPECT_EQ(hex(content_hash("abc")), "ba7816bf8f01cfea414140de5dae2223");
  EXPECT_EQ(hex(content_hash("")), "e3b0c44298fc1c149afbf4c8996fb924");
}

TEST(ContentHash, IsReadBackFromItsText) {
  const ContentHash hash = content_hash("a stop");
  EXPECT_EQ(parse_hash(hex(hash)), hash);
}

TEST(ContentHash, IsNoOtherText) {
  const std::string text = hex(content_hash("abc"));
  for (const std::string& other : {text.substr(1),
                                   text + "0",
                                   std::string(),
                                   "BA" + text.substr(2),
                                   "g" + text.substr(1),
                                   " " + text.substr(1)}) {
    EXPECT_FALSE(parse_hash(other)) << other;
  }
}

TEST(ContentHash, OfASetDoesNotDependOnItsOrderButOnEveryMember) {
  std::vector<ContentHash> objects{content_hash("a"), content_hash("b"), content_hash("c")};
  const ContentHash all = set_hash(objects);
  std::swap(objects.front(), objects.back());
  EXPECT_EQ(set_hash(objects), all);
  objects.pop_back();
  EXPECT_NE(set_hash(objects), all);
  EXPECT_NE(set_hash({}), all);
}

TEST(ContentHash, FillsTheBucketsOfATable) {
  std::vector<std::size_t> buckets;
  for (int i = 0; i < 1000; ++i) {
    buckets.push_back(ContentHashBucket{}(content_hash(std::to_string(i))) % 100);
  }
  std::sort(buckets.begin(), buckets.end());
  EXPECT_EQ(std::unique(buckets.begin(), buckets.end()) - buckets.begin(), 100);
}

}  // namespace
}  // namespace echomap::fleet_messages
