// SPDX-License-Identifier: MIT
#include "host/broker/configuration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::broker {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

BrokerSettings lab_settings() {
  BrokerSettings settings;
  settings.fleet = "lab";
  settings.users = {{"robot1", "secret-of-1"}, {"hub", "secret-of-hub"}};
  return settings;
}

TEST(BrokerRights, AreByUserNameAndNeverByClientId) {
  EXPECT_EQ(broker_rights(lab_settings()),
            "# Written by echomap at every start of the broker; changes are lost.\n"
            "pattern write echomap/1/lab/%u/#\n"
            "\n"
            "user robot1\n"
            "topic read echomap/1/lab/#\n"
            "\n"
            "user hub\n"
            "topic read #\n"
            "topic read $SYS/#\n");
}

TEST(BrokerConfiguration, HasNoSecretAndNoAnonymousClient) {
  EXPECT_THAT(broker_configuration(lab_settings(), 1884, "/b", std::nullopt),
              AllOf(HasSubstr("listener 1884 127.0.0.1\n"),
                    HasSubstr("allow_anonymous false\n"),
                    HasSubstr("use_username_as_clientid true\n"),
                    HasSubstr("acl_file /b/rights.acl\n"),
                    Not(HasSubstr("secret-of")),
                    Not(HasSubstr("certfile")),
                    Not(HasSubstr("connection "))));
}

TEST(BrokerConfiguration, ThePacketIsAsLargeAsThePayloadAndItsTopic) {
  BrokerSettings settings = lab_settings();
  settings.max_payload_bytes = 5000;
  settings.max_queued_bytes = 70000;
  settings.save_interval_s = 7;
  EXPECT_THAT(broker_configuration(settings, 1, "/b", std::nullopt),
              AllOf(HasSubstr("message_size_limit 5000\n"),
                    HasSubstr("max_packet_size 6024\n"),
                    HasSubstr("max_queued_bytes 70000\n"),
                    HasSubstr("autosave_interval 7\n")));
}

TEST(BrokerConfiguration, WithCertificatesThereIsNoPlainListener) {
  const std::string text =
      broker_configuration(lab_settings(), 8883, "/b", Certificates{"/c/ca", "/c/s", "/c/k"});
  EXPECT_THAT(
      text,
      AllOf(
          HasSubstr("cafile /c/ca\n"), HasSubstr("certfile /c/s\n"), HasSubstr("keyfile /c/k\n")));
  EXPECT_EQ(text.find("listener"), text.rfind("listener"));
}

TEST(BrokerConfiguration, ABridgeTakesWhatIsClosedBelowTheSitesName) {
  const SiteBridge bridge{"up.example", 8883, "region", "site7", "secret-of-7", "/up/ca.crt"};
  EXPECT_THAT(bridge_configuration(bridge, "lab"),
              AllOf(HasSubstr("connection site7\naddress up.example:8883\n"),
                    HasSubstr("bridge_cafile /up/ca.crt\n"),
                    HasSubstr("topic +/submap/+ out 1 echomap/1/lab/ echomap/1/region/site7/\n"),
                    HasSubstr("topic +/manifest/+ out 1 echomap/1/lab/ echomap/1/region/site7/\n"),
                    Not(HasSubstr("pose")),
                    Not(HasSubstr("claim")),
                    Not(HasSubstr(" both ")),
                    Not(HasSubstr(" in "))));
}

}  // namespace
}  // namespace echomap::broker
