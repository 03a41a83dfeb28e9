// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/running_broker.hpp"

// A site's broker hands on to a region's what is closed: two real brokers on loopback.
namespace echomap::broker {
namespace {

using mqtt::Delivery;
using mqtt::Message;
using tests::Client;

class BridgeTest : public testing::Test {
 protected:
  static BrokerSettings region_settings() {
    BrokerSettings settings = tests::broker_settings({"site7", "hub"});
    settings.fleet = "region";
    settings.tls = true;
    return settings;
  }

  BrokerSettings site_settings() {
    const Credentials up = region_->credentials("site7");
    BrokerSettings settings = tests::broker_settings({"robot1", "hub"});
    settings.bridge = SiteBridge{up.host, up.port, up.fleet, up.user, up.password, up.ca_file};
    return settings;
  }

  static std::string site_topic(const std::string& rest) { return "echomap/1/lab/robot1/" + rest; }
  static std::string region_topic(const std::string& rest) {
    return "echomap/1/region/site7/robot1/" + rest;
  }

  static void publish_all(Client& robot) {
    for (const std::string kind : {"pose", "claim", "clock", "source/1", "ask"}) {
      robot->publish(site_topic(kind), kind, Delivery::kAtLeastOnce, false);
    }
    for (const std::string kind : {"presence", "graph/0", "submap/1", "submap/2", "manifest/0"}) {
      robot->publish(site_topic(kind), kind, Delivery::kAtLeastOnce, true);
    }
    EXPECT_TRUE(robot.is_acknowledged());
  }

  /// Topics that the region hears until it has the manifest.
  static std::set<std::string> topics_until_manifest(Client hub) {
    const auto has_all = [&] {
      return hub.heard().size() >= 5 &&
             std::ranges::any_of(hub.heard(), [](const Message& message) {
               return message.topic == region_topic("manifest/0");
             });
    };
    EXPECT_TRUE(hub.serve_until(has_all));
    std::set<std::string> topics;
    for (const Message& message : hub.heard()) {
      topics.insert(message.topic);
    }
    return topics;
  }

  tests::RunningBroker region_{region_settings()};
  tests::RunningBroker site_{site_settings()};
  std::set<std::string> closed_{region_topic("presence"),
                                region_topic("graph/0"),
                                region_topic("submap/1"),
                                region_topic("submap/2"),
                                region_topic("manifest/0")};
};

TEST_F(BridgeTest, TakesUpWhatIsClosedAndNoPoses) {
  Client hub(region_.params("hub"), "echomap/#");
  Client robot(site_.params("robot1"));
  publish_all(robot);
  EXPECT_EQ(topics_until_manifest(std::move(hub)), closed_);
}

TEST_F(BridgeTest, BringsEverythingAgainWhenTheRegionWasKilled) {
  Client robot(site_.params("robot1"));
  publish_all(robot);
  ASSERT_EQ(topics_until_manifest(Client(region_.params("hub"), "echomap/#")), closed_);
  region_->kill();
  region_->start();
  EXPECT_EQ(topics_until_manifest(Client(region_.params("hub"), "echomap/#")), closed_);
}

}  // namespace
}  // namespace echomap::broker
