// SPDX-License-Identifier: MIT
#include "host/live_page/connection_list.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace echomap::live_page {
namespace {

using std::chrono::steady_clock;

class CountedConnection final : public Connection {
 public:
  void close() override {
    ++closed;
    place.reset();
  }
  steady_clock::time_point blocked_since() const override { return since; }

  ConnectionList::Place place;
  steady_clock::time_point since = steady_clock::time_point::max();
  int closed = 0;
};

std::shared_ptr<CountedConnection> added_to(ConnectionList& list) {
  auto connection = std::make_shared<CountedConnection>();
  connection->place = list.add(connection);
  return connection;
}

TEST(ConnectionList, IsFullAtItsBoundUntilOneEnds) {
  ConnectionList list(2);
  const auto first = added_to(list);
  auto second = added_to(list);
  EXPECT_TRUE(list.is_full());
  second.reset();
  EXPECT_FALSE(list.is_full());
  EXPECT_EQ(list.size(), 1U);
}

TEST(ConnectionList, ClosesThoseThatHaveWaitedTooLong) {
  ConnectionList list(10);
  const auto idle = added_to(list);
  const auto slow = added_to(list);
  const auto stuck = added_to(list);
  slow->since = steady_clock::now();
  stuck->since = steady_clock::now() - std::chrono::seconds(11);
  list.close_blocked(std::chrono::seconds(10));
  EXPECT_EQ(idle->closed, 0);
  EXPECT_EQ(slow->closed, 0);
  EXPECT_EQ(stuck->closed, 1);
  EXPECT_EQ(list.size(), 2U);
}

TEST(ConnectionList, ClosesAll) {
  ConnectionList list(10);
  const auto first = added_to(list);
  const auto second = added_to(list);
  list.close_all();
  EXPECT_EQ(first->closed + second->closed, 2);
  EXPECT_EQ(list.size(), 0U);
}

TEST(ConnectionList, LeavesDescriptorsToTheRun) {
  EXPECT_LE(max_connections_of_this_process(), 1200U);
  EXPECT_GE(max_connections_of_this_process(), 16U);
}

}  // namespace
}  // namespace echomap::live_page
