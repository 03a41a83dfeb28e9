// SPDX-License-Identifier: MIT
#include "host/mqtt/connection.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mqtt/packet_size.hpp"
#include "tests/support/late_join.hpp"
#include "tests/support/running_broker.hpp"
#include "tests/support/tcp_proxy.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::mqtt {
namespace {

using boost::asio::ip::tcp;
using testing::ElementsAre;
using testing::IsEmpty;
using tests::Client;
using tests::eventually;

/// A broker with two robots and a hub, which hears everything.
class ConnectionTest : public testing::Test {
 protected:
  static constexpr auto kFleet = "echomap/1/lab/";

  static std::string topic(const std::string& rest) { return kFleet + rest; }
  static std::vector<std::string> payloads(const std::vector<Message>& messages) {
    std::vector<std::string> texts;
    for (const Message& message : messages) {
      texts.push_back(message.payload + (message.is_retained ? " retained" : ""));
    }
    return texts;
  }

  Client robot1() const { return Client(broker_.params("robot1")); }
  Client hub() const { return Client(broker_.params("hub"), "#"); }

  /// The reason why there is no connection, once there is one.
  static Reason reason_for(const ConnectionParams& params) {
    Connection connection(params);
    std::vector<Message> received;
    tests::serve_until(connection, received, [&] { return connection.reason() != Reason::kNone; });
    EXPECT_EQ(connection.connections(), 0U);
    EXPECT_FALSE(connection.is_connected());
    return connection.reason();
  }

  tests::RunningBroker broker_{tests::broker_settings({"robot1", "robot2", "hub"})};
};

TEST_F(ConnectionTest, CarriesAnyBytesOfBothKindsInTheirOrder) {
  Client hub = this->hub();
  Client robot = robot1();
  const std::string bytes("a\0b\xff", 4);
  EXPECT_TRUE(robot->publish(topic("robot1/pose"), bytes, Delivery::kAtMostOnce, false));
  EXPECT_TRUE(robot->publish(topic("robot1/claim"), "", Delivery::kAtLeastOnce, false));
  EXPECT_TRUE(robot->publish(topic("robot1/clock"), "last", Delivery::kAtLeastOnce, false));
  EXPECT_TRUE(robot.is_acknowledged());

  const auto received = hub.heard_until("last");
  EXPECT_THAT(payloads(received), ElementsAre(bytes, "", "last"));
  EXPECT_EQ(received.front().topic, topic("robot1/pose"));
  EXPECT_EQ(robot->statistics().published, 3U);
  EXPECT_EQ(robot->statistics().acked, 2U);
  EXPECT_EQ(robot->statistics().published_bytes, 3 * topic("robot1/").size() + 4 + 4 + 5 + 5 + 4);
  EXPECT_EQ(hub->statistics().received, 3U);
}

TEST_F(ConnectionTest, WhatIsRetainedComesToThoseWhoSubscribeLate) {
  Client robot = robot1();
  robot->publish(topic("robot1/manifest"), "old", Delivery::kAtLeastOnce, true);
  robot->publish(topic("robot1/manifest"), "new", Delivery::kAtLeastOnce, true);
  ASSERT_TRUE(robot.is_acknowledged());
  EXPECT_THAT(payloads(hub().heard_until("new")), ElementsAre("new retained"));
}

TEST_F(ConnectionTest, WaitsWithWhatIsPublishedBeforeThereIsALine) {
  Client hub = this->hub();
  Connection robot(broker_.params("robot1"));
  robot.publish(topic("robot1/pose"), "stale", Delivery::kAtMostOnce, false);
  robot.publish(topic("robot1/claim"), "kept", Delivery::kAtLeastOnce, false);
  EXPECT_EQ(robot.unacknowledged(), 1U);
  EXPECT_TRUE(tests::is_acknowledged(robot));
  EXPECT_THAT(payloads(hub.heard_until("kept")), ElementsAre("kept"));
  EXPECT_EQ(robot.statistics().dropped, 1U);
}

TEST_F(ConnectionTest, ReportsAWrongPassword) {
  ConnectionParams params = broker_.params("robot1");
  params.password += "x";
  EXPECT_EQ(reason_for(params), Reason::kWrongPassword);
  params = broker_.params("robot1");
  params.user.clear();
  EXPECT_EQ(reason_for(params), Reason::kWrongPassword);
}

TEST_F(ConnectionTest, ReportsWhatTheBrokerRefusesAndKeepsTheLine) {
  Client robot = robot1();
  robot->publish(topic("robot2/pose"), "forged", Delivery::kAtLeastOnce, false);
  robot->publish(topic("robot1/+"), "no topic", Delivery::kAtLeastOnce, false);
  ASSERT_TRUE(robot.is_acknowledged());
  EXPECT_EQ(robot->statistics().refused, 2U);
  ASSERT_TRUE(robot->last_refused());
  EXPECT_EQ(robot->last_refused()->topic, topic("robot2/pose"));
  EXPECT_EQ(robot->last_refused()->reason, Reason::kNotAuthorized);
  EXPECT_TRUE(robot->is_connected());
}

TEST_F(ConnectionTest, SendsWhatFitsToTheByteAndNothingLarger) {
  Client hub = this->hub();
  Client robot = robot1();
  const std::string name = topic("robot1/submap/1");
  ASSERT_TRUE(robot->max_packet_bytes());
  const std::size_t overhead = publish_packet_bytes(name.size(), 100'000) - 100'000;
  const std::string fits(*robot->max_packet_bytes() - overhead, 'x');
  EXPECT_FALSE(robot->publish(name, fits + 'x', Delivery::kAtLeastOnce, false));
  EXPECT_EQ(robot->statistics().too_large, 1U);
  // The payload alone is over its own limit: the broker answers, and the line stays.
  EXPECT_TRUE(robot->publish(name, fits, Delivery::kAtLeastOnce, false));
  ASSERT_TRUE(robot.is_acknowledged());
  EXPECT_EQ(robot->last_refused()->reason, Reason::kTooLarge);
  EXPECT_EQ(robot->connections(), 1U);
  const std::string largest(broker::BrokerSettings{}.max_payload_bytes, 'y');
  EXPECT_TRUE(robot->publish(name, largest, Delivery::kAtLeastOnce, false));
  EXPECT_TRUE(robot.is_acknowledged());
  EXPECT_FALSE(hub.heard_until(largest).empty());
  EXPECT_EQ(robot->connections(), 1U);
}

TEST_F(ConnectionTest, DropsWhatTurnsOutToBeTooLargeWhenItIsConnected) {
  Connection robot(broker_.params("robot1"));
  const std::string large(2'000'000, 'x');
  EXPECT_TRUE(robot.publish(topic("robot1/graph"), large, Delivery::kAtLeastOnce, true));
  EXPECT_TRUE(tests::is_acknowledged(robot));
  EXPECT_EQ(robot.statistics().too_large, 1U);
  EXPECT_EQ(robot.connections(), 1U);
}

TEST_F(ConnectionTest, ComesBackWhenTheBrokerWasKilled) {
  Client hub = this->hub();
  Client robot = robot1();
  broker_->kill();
  ASSERT_TRUE(eventually([&] {
    robot->take();
    hub->take();
    return !robot->is_connected() && !hub->is_connected();
  }));
  EXPECT_EQ(robot->reason(), Reason::kLost);
  robot->publish(topic("robot1/claim"), "meanwhile", Delivery::kAtLeastOnce, false);
  ASSERT_TRUE(eventually([&] {
    robot->take();
    return robot->reason() == Reason::kUnreachable;
  }));
  broker_->start();
  ASSERT_TRUE(hub.serve_until([&] { return hub->connections() == 2; }));
  EXPECT_TRUE(robot.is_acknowledged());
  EXPECT_THAT(payloads(hub.heard_until("meanwhile")), ElementsAre("meanwhile"));
  EXPECT_EQ(robot->statistics().reconnects, 1U);
  EXPECT_GT(robot->statistics().failed_attempts, 0U);
  EXPECT_EQ(robot->reason(), Reason::kNone);
}

TEST_F(ConnectionTest, WhatWasNotAcknowledgedIsSentAgainAfterACut) {
  tests::TcpProxy proxy(broker_->port());
  ConnectionParams params = broker_.params("robot1");
  params.port = proxy.port();
  Client hub = this->hub();
  Client robot(params);
  proxy.stall();
  for (int i = 0; i < 300; ++i) {
    robot->publish(topic("robot1/submap/") + std::to_string(i), "s", Delivery::kAtLeastOnce, true);
    robot->take();
  }
  EXPECT_EQ(robot->unacknowledged(), 300U);
  proxy.cut();
  ASSERT_TRUE(eventually([&] {
    robot->take();
    return !robot->is_connected();
  }));
  proxy.resume();
  EXPECT_TRUE(robot.is_acknowledged());
  robot->publish(topic("robot1/claim"), "end", Delivery::kAtLeastOnce, false);
  robot->take();
  EXPECT_EQ(hub.heard_until("end").size(), 301U);
}

TEST_F(ConnectionTest, OneWhoAsksForNothingTooOftenIsDroppedNotKept) {
  tests::TcpProxy proxy(broker_->port());
  ConnectionParams params = broker_.params("robot1");
  params.port = proxy.port();
  Client robot(params);
  proxy.stall();
  const std::string pose(10'000, 'p');
  for (int i = 0; i < 5000; ++i) {
    robot->publish(topic("robot1/pose"), pose, Delivery::kAtMostOnce, false);
  }
  EXPECT_GT(robot->statistics().dropped, 1000U);
}

TEST_F(ConnectionTest, TheWillComesUnlessTheEndIsInOrder) {
  Client hub = this->hub();
  ConnectionParams params = broker_.params("robot1");
  params.will = LastWill{topic("robot1/presence"), "gone", true};
  { const Client client(params); }
  EXPECT_THAT(payloads(hub.heard_until("gone")), ElementsAre("gone"));

  Client robot(params);
  robot->disconnect();
  EXPECT_FALSE(robot->is_connected());
  robot->take();
  EXPECT_FALSE(robot->is_connected());
  Client other(broker_.params("robot2"));
  other->publish(topic("robot2/claim"), "end", Delivery::kAtLeastOnce, false);
  EXPECT_THAT(payloads(hub.heard_until("end")), ElementsAre("gone", "end")) << "of before";
}

TEST_F(ConnectionTest, TheWillOfOneThatIsCutOffComesToo) {
  tests::TcpProxy proxy(broker_->port());
  Client hub = this->hub();
  ConnectionParams params = broker_.params("robot1");
  params.port = proxy.port();
  params.will = LastWill{topic("robot1/presence"), "gone", true};
  Client robot(params);
  proxy.cut();
  EXPECT_THAT(payloads(hub.heard_until("gone")), ElementsAre("gone"));
}

TEST_F(ConnectionTest, AStolenClientIdThrowsNobodyOut) {
  Client robot = robot1();
  ConnectionParams params = broker_.params("robot2");
  params.client_id = "robot1";
  Client thief(params);
  robot->publish(topic("robot1/claim"), "mine", Delivery::kAtLeastOnce, false);
  EXPECT_TRUE(robot.is_acknowledged());
  EXPECT_EQ(robot->connections(), 1U);
  EXPECT_EQ(robot->statistics().refused, 0U);
}

// MQTT 5 has a code for it, 0x8e; Mosquitto 2.0 closes the connection without one.
TEST_F(ConnectionTest, OfTwoOfOneUserTheSecondHolds) {
  ConnectionParams params = broker_.params("robot1");
  params.backoff.first_s = 3600.0;
  params.backoff.max_s = 3600.0;
  Client first(params);
  Client second(params);
  ASSERT_TRUE(eventually([&] {
    first->take();
    return !first->is_connected();
  }));
  EXPECT_TRUE(first->reason() == Reason::kTakenOver || first->reason() == Reason::kLost);
  EXPECT_EQ(first->was_taken_over(), first->reason() == Reason::kTakenOver);
  first->take();
  second->take();
  EXPECT_FALSE(first->is_connected()) << "it waits";
  EXPECT_TRUE(second->is_connected());
}

TEST_F(ConnectionTest, SubscribesWhileItIsConnected) {
  Client robot = robot1();
  robot->subscribe(topic("robot2/#"));
  Client other(broker_.params("robot2"));
  // The subscription is on its way; whoever is late gets what is retained.
  other->publish(topic("robot2/graph"), "g", Delivery::kAtLeastOnce, true);
  ASSERT_TRUE(other.is_acknowledged());
  EXPECT_FALSE(robot.heard_until("g").empty());
  EXPECT_THROW(robot->subscribe("a/#/b"), std::invalid_argument);
}

TEST_F(ConnectionTest, ReportsThatNobodyListensOrAnswers) {
  boost::asio::io_context io;
  tcp::acceptor silent(io, {boost::asio::ip::address_v4::loopback(), 0});
  ConnectionParams params = broker_.params("robot1");
  params.port = silent.local_endpoint().port();
  params.answer_s = 0.1;
  EXPECT_EQ(reason_for(params), Reason::kSilent);
  silent.close();
  EXPECT_EQ(reason_for(params), Reason::kUnreachable);
  params.host = "no-such-host.invalid";
  EXPECT_EQ(reason_for(params), Reason::kUnknownHost);
}

TEST_F(ConnectionTest, RefusesParametersOutsideOfTheirRange) {
  ConnectionParams params = broker_.params("robot1");
  params.keep_alive_s = 4;
  EXPECT_EQ(tests::thrown_text<std::invalid_argument>([&] { Connection connection(params); }),
            "MQTT connection: keep_alive_s = 4 is outside 5 .. 65535");
  params = broker_.params("robot1");
  params.client_id.clear();
  EXPECT_THROW(Connection connection(params), std::invalid_argument);
  params = broker_.params("robot1");
  params.will = LastWill{"a/+", "", true};
  EXPECT_THROW(Connection connection(params), std::invalid_argument);
  params = broker_.params("robot1");
  params.ca_file = "/no/such/ca.crt";
  EXPECT_THAT(tests::thrown_text<std::runtime_error>([&] { Connection connection(params); }),
              testing::HasSubstr("/no/such/ca.crt"));
}

/// A broker that speaks TLS, and another one, whose CA is another.
class TlsConnectionTest : public ConnectionTest {
 protected:
  static broker::BrokerSettings tls_settings() {
    broker::BrokerSettings settings = tests::broker_settings({"robot1"});
    settings.tls = true;
    return settings;
  }

  tests::RunningBroker safe_{tls_settings()};
};

TEST_F(TlsConnectionTest, IsMadeToABrokerOfItsCaOnly) {
  const ConnectionParams params = safe_.params("robot1");
  EXPECT_FALSE(params.ca_file.empty());
  Client robot(params, "#");
  const std::string large(300'000, 'x');
  robot->publish(topic("robot1/graph"), large, Delivery::kAtLeastOnce, false);
  EXPECT_TRUE(robot.is_acknowledged());

  const tests::RunningBroker foreign(tls_settings());
  ConnectionParams wrong = params;
  wrong.ca_file = foreign.params("robot1").ca_file;
  EXPECT_EQ(reason_for(wrong), Reason::kTlsFailed);
}

TEST_F(TlsConnectionTest, APlainClientLearnsThatThePortMayWantTls) {
  ConnectionParams plain = safe_.params("robot1");
  plain.ca_file.clear();
  EXPECT_EQ(reason_for(plain), Reason::kClosedUnanswered);
}

TEST_F(TlsConnectionTest, APlainBrokerIsNoneForTls) {
  ConnectionParams params = broker_.params("robot1");
  params.ca_file = safe_.params("robot1").ca_file;
  EXPECT_EQ(reason_for(params), Reason::kTlsFailed);
}

TEST_F(TlsConnectionTest, WorksOverALineWithDelay) {
  tests::TcpProxy proxy(safe_->port());
  proxy.set_delay(std::chrono::milliseconds(50));
  ConnectionParams params = safe_.params("robot1");
  params.port = proxy.port();
  Client robot(params);
  robot->publish(topic("robot1/graph"), "g", Delivery::kAtLeastOnce, false);
  EXPECT_TRUE(robot.is_acknowledged());
}

TEST_F(ConnectionTest, ALineThatIsSilentIsGivenUp) {
  tests::TcpProxy proxy(broker_->port());
  ConnectionParams params = broker_.params("robot1");
  params.port = proxy.port();
  params.keep_alive_s = 5;
  params.answer_s = 1.0;
  Client robot(params);
  proxy.stall();
  ASSERT_TRUE(robot.serve_until([&] { return !robot->is_connected(); }));
  EXPECT_EQ(robot->reason(), Reason::kSilent);
  proxy.resume();
  EXPECT_TRUE(robot.serve_until([&] { return robot->connections() == 2; }));
}

TEST_F(ConnectionTest, OneWhoJoinsLateGetsTenThousandObjects) {
  constexpr std::size_t kObjects = 10'000;
  const tests::LateJoin join = tests::join_late(kObjects);
  EXPECT_EQ(join.dropped, 0U);
  EXPECT_EQ(join.objects, kObjects);
  EXPECT_TRUE(join.are_retained);
}

}  // namespace
}  // namespace echomap::mqtt
