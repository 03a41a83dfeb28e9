// SPDX-License-Identifier: MIT
#include "host/live_page/live_clients.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/live_page/served_page.hpp"

namespace echomap::live_page {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Keeps what a client would get.
class KeptTexts final : public FrameSender {
 public:
  void send(Frame frame) override { texts.push_back(*frame.bytes); }
  void close() override {}

  std::vector<std::string> texts;
};

class LiveClientsTest : public testing::Test {
 protected:
  std::shared_ptr<History> history_ = std::make_shared<History>();
  std::vector<session::OperatorCommand> commands_;
  LiveClients clients_{
      CommandHandler(std::vector<std::string>{"drive", "explore"}, [] { return 1000.0; }),
      history_,
      [this](const session::OperatorCommand& command) { commands_.push_back(command); }};
};

TEST_F(LiveClientsTest, TellEachItsNumberAndWhatThereIs) {
  history_->add(made_message(MessageKind::kHello, 0, "hello"));
  const auto first = std::make_shared<KeptTexts>();
  const auto second = std::make_shared<KeptTexts>();
  EXPECT_EQ(clients_.join(first), 1U);
  EXPECT_EQ(clients_.join(second), 2U);
  clients_.send(LiveClients::frame_of(made_message(MessageKind::kEvent, 0, "event")));
  EXPECT_THAT(first->texts, ElementsAre(R"({"client": 1})", "hello", "event"));
  EXPECT_THAT(second->texts, ElementsAre(R"({"client": 2})", "hello", "event"));
}

TEST_F(LiveClientsTest, SendNothingToThoseWhoHaveLeft) {
  const auto sender = std::make_shared<KeptTexts>();
  const auto number = clients_.join(sender);
  clients_.leave(number);
  clients_.send(text_frame("late"));
  EXPECT_THAT(sender->texts, ElementsAre(R"({"client": 1})"));
  EXPECT_EQ(sender.use_count(), 1);
}

TEST_F(LiveClientsTest, SpeakEchomapV1) {
  const NamedProtocol protocol = echomap_protocol(clients_);
  EXPECT_EQ(protocol.name, "echomap.v1");
  const auto sender = std::make_shared<KeptTexts>();
  {
    const auto client = protocol.connect(sender);
    client->on_text(R"({"do": "drive", "seq": 1, "forward": 1, "turn": 0, "seen": 1000})");
    EXPECT_EQ(sender->texts.back(), R"({"ack":1,"ok":true})");
    client->on_binary("\x01\x02");
    EXPECT_THAT(sender->texts.back(), testing::HasSubstr("malformed"));
    EXPECT_EQ(clients_.driver()->client, 1U);
  }
  ASSERT_EQ(commands_.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<session::SteerRobot>(commands_[0]));
  EXPECT_TRUE(std::holds_alternative<session::StopRobot>(commands_[1]));
}

TEST_F(LiveClientsTest, PassNothingOnAfterTheEnd) {
  clients_.stop_listening();
  clients_.take_post(R"({"do": "stop"})");
  EXPECT_THAT(commands_, IsEmpty());
}

TEST(FrameOfAMessage, SharesItsBytesAndHasTheChannelOfAState) {
  const SharedMessage tile = made_message(MessageKind::kTile, 7, "tile");
  const Frame frame = LiveClients::frame_of(tile);
  EXPECT_EQ(frame.bytes.get(), &tile->bytes);
  EXPECT_EQ(frame.channel, FrameChannel(2, 7));
  EXPECT_FALSE(frame.is_text);
  EXPECT_FALSE(LiveClients::frame_of(made_message(MessageKind::kNewMap, 0, "")).channel);
}

}  // namespace
}  // namespace echomap::live_page
