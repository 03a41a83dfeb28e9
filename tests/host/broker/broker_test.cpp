// SPDX-License-Identifier: MIT
#include "host/broker/broker.hpp"

#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/running_broker.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::broker {
namespace {

namespace fs = std::filesystem;
using mqtt::Delivery;
using testing::HasSubstr;
using testing::Not;
using tests::Client;

constexpr auto kTopic = "echomap/1/lab/robot1/manifest";

/// Publishes a retained message of robot1.
void retain(tests::RunningBroker& broker, const std::string& payload) {
  Client robot(broker.params("robot1"));
  robot->publish(kTopic, payload, Delivery::kAtLeastOnce, true);
  ASSERT_TRUE(robot.is_acknowledged());
}

/// What the broker retains of robot1; empty where it has nothing.
std::string retained_in(tests::RunningBroker& broker) {
  Client hub(broker.params("hub"), kTopic);
  hub->publish("echomap/1/lab/hub/end", "end", Delivery::kAtLeastOnce, true);
  hub->subscribe("echomap/1/lab/hub/end");
  const auto heard = hub.heard_until("end");
  return heard.size() == 2 ? heard.front().payload : "";
}

class BrokerTest : public testing::Test {
 protected:
  tests::RunningBroker broker_{tests::broker_settings({"robot1", "hub"})};
};

TEST_F(BrokerTest, ItsFolderIsTheUsersAloneAndNamesThePort) {
  EXPECT_EQ(fs::status(broker_->folder()).permissions() & fs::perms::all, fs::perms::owner_all);
  EXPECT_EQ(files::read_text_file(broker_->folder() / "port"),
            std::to_string(broker_->port()) + "\n");
  const Credentials read = read_credentials(broker_->credentials_file("robot1"));
  EXPECT_EQ(read.port, broker_->port());
  EXPECT_EQ(read.password, broker_->credentials("robot1").password);
  EXPECT_NO_THROW(Client(connection_params(read)));
}

TEST_F(BrokerTest, NoFileOfItsHasAPasswordButTheMembers) {
  const std::string password = broker_->credentials("robot1").password;
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(broker_->folder())) {
    if (entry.is_regular_file() && entry.path().parent_path().filename() != "members") {
      EXPECT_THAT(files::read_text_file(entry.path()), Not(HasSubstr(password))) << entry.path();
      ++files;
    }
  }
  EXPECT_GT(files, 3U);
}

TEST_F(BrokerTest, KeepsWhatIsRetainedWhenItIsStopped) {
  retain(broker_, "kept");
  const auto port = broker_->port();
  broker_->stop();
  EXPECT_FALSE(broker_->is_running());
  broker_->start();
  EXPECT_EQ(broker_->port(), port);
  EXPECT_EQ(retained_in(broker_), "kept");
}

TEST_F(BrokerTest, LosesAtAKillWhatItHasNotSaved) {
  retain(broker_, "saved");
  broker_->stop();
  broker_->start();
  retain(broker_, "acknowledged");
  broker_->kill();
  EXPECT_FALSE(broker_->is_running());
  broker_->start();
  EXPECT_EQ(retained_in(broker_), "saved") << "an acknowledgement is no promise";
}

TEST_F(BrokerTest, NoticesThatItHasEnded) {
  EXPECT_TRUE(broker_->is_running());
  ::kill(broker_->pid(), SIGKILL);
  EXPECT_TRUE(tests::eventually([&] { return !broker_->is_running(); }));
}

TEST_F(BrokerTest, TakesOtherAccountsWhileItRuns) {
  Client hub(broker_.params("hub"), "#");
  BrokerSettings settings = tests::broker_settings({"robot1", "late"});
  settings.users.push_back({"hub", broker_->credentials("hub").password});
  broker_->set_users(settings.users);

  Client late(broker_.params("late"));
  late->publish("echomap/1/lab/late/pose", "here", Delivery::kAtLeastOnce, false);
  EXPECT_TRUE(late.is_acknowledged());
  EXPECT_FALSE(hub.heard_until("here").empty());
  EXPECT_EQ(hub->connections(), 1U) << "those who stay are not disturbed";
}

TEST_F(BrokerTest, RemovesTheFileOfAnAccountThatIsGone) {
  ASSERT_TRUE(fs::exists(broker_->credentials_file("robot1")));
  BrokerSettings settings = tests::broker_settings({"late"});
  settings.users.push_back({"hub", broker_->credentials("hub").password});
  broker_->set_users(settings.users);
  EXPECT_FALSE(fs::exists(broker_->folder() / "members/robot1.toml"));
  EXPECT_TRUE(fs::exists(broker_->credentials_file("late")));
  EXPECT_TRUE(fs::exists(broker_->credentials_file("hub")));
}

TEST(BrokerAddress, OfNoMachineInParticularIsKnownInAnySpelling) {
  EXPECT_TRUE(is_unspecified("0.0.0.0"));
  EXPECT_TRUE(is_unspecified("0:0:0:0:0:0:0:0"));
  EXPECT_FALSE(is_unspecified("127.0.0.1"));
  EXPECT_THROW(is_unspecified("localhost"), console::CommandError);
}

TEST_F(BrokerTest, APortThatIsTakenIsNamed) {
  BrokerSettings settings = tests::broker_settings({"robot1"});
  settings.port = broker_->port();
  EXPECT_THAT(
      tests::thrown_text<console::CommandError>(
          [&] { const tests::RunningBroker second(settings); }),
      testing::AllOf(HasSubstr("port " + std::to_string(broker_->port())), HasSubstr("next: ")));
}

TEST(BrokerStart, RefusesAnAddressThatIsNotOfThisMachine) {
  BrokerSettings settings = tests::broker_settings({"robot1"});
  settings.address = "192.0.2.1";
  EXPECT_THAT(tests::thrown_text<console::CommandError>(
                  [&] { const tests::RunningBroker broker(settings); }),
              HasSubstr("cannot listen on 192.0.2.1"));
  settings.address = "robots.example";
  EXPECT_THAT(tests::thrown_text<console::CommandError>(
                  [&] { const tests::RunningBroker broker(settings); }),
              HasSubstr("'robots.example' is no IP address"));
}

TEST(BrokerStart, ItsCertificateIsForTheAddressWhereItListens) {
  BrokerSettings settings = tests::broker_settings({"robot1"});
  settings.address = "127.0.0.2";
  settings.tls = true;
  tests::RunningBroker broker(settings);
  EXPECT_EQ(broker->credentials("robot1").host, "127.0.0.2");
  EXPECT_NO_THROW(Client(broker.params("robot1")));
}

TEST(BrokerStart, AFolderCanBeUsedAgain) {
  const tests::ScratchFolder folder;
  const BrokerSettings settings = tests::broker_settings({"robot1"});
  const auto port = Broker(settings, folder / "b").port();
  EXPECT_NE(port, 0);
  Broker again(settings, folder / "b");
  EXPECT_NO_THROW(Client(connection_params(again.credentials("robot1"))));
}

}  // namespace
}  // namespace echomap::broker
