// SPDX-License-Identifier: MIT
/// What a client by others (foxglove_client.mjs) makes of a run while it is recorded.
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/live_page/foxglove_protocol.hpp"
#include "host/live_page/page_server.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/recording/session_recorder.hpp"
#include "host/ros_messages/rcl_interfaces.hpp"
#include "tests/structure/shell.hpp"
#include "tests/support/robot_times.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::live_page {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using structure::shell_quoted;
using testing::IsEmpty;
using tests::at_us;

/// A robot that drives ahead, 50 odometry messages a second, and hears something now and then.
void drive(recording::SessionRecorder& recorder, const std::stop_token& stop) {
  recorder.begin_session(0);
  pipeline::RobotPipeline pipeline((sensors::RobotGeometry()));
  for (int i = 0; !stop.stop_requested(); ++i) {
    const double travel_m = 0.001 * i;
    recorder.set_time(time::HostTime(20ms * i));
    recorder.on_odometry({at_us(20'000 * i), {travel_m, travel_m}});
    pipeline.on_odometry({at_us(20'000 * i), {travel_m, travel_m}});
    if (i % 25 == 0) {
      recorder.on_sonar({at_us(20'000 * i), {travel_m, travel_m}, 0.5, 1.0});
      pipeline.begin_scan();
      pipeline.on_sonar({at_us(20'000 * i), {travel_m, travel_m}, 0.0, 1.0});
      pipeline.end_scan();
      recorder.add_map(pipeline.snapshot());
      recorder.add_log(ros_messages::Log::kInfo, "stop " + std::to_string(i / 25));
    }
    std::this_thread::sleep_for(20ms);
  }
}

class FoxglovePeers : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(ECHOMAP_LIVE_PAGE_PEERS "/installed")) {
      GTEST_SKIP() << "no node 20, no npm, or its packages could not be installed";
    }
    files::write_text_file(scratch / "index.html", "<!doctype html>");
    files::write_text_file(scratch / "openapi.json", "{}");
  }
  PageServerParams params() {
    PageServerParams params;
    params.page_folder = scratch.path();
    params.openapi_file = scratch / "openapi.json";
    params.protocols = foxglove_protocols(topics);
    return params;
  }
  /// What the client says after two seconds.
  json summary(const std::string& page_url) const {
    const std::string url = "ws" + page_url.substr(page_url.find(':')) + "ws";
    const auto result = structure::run_shell(
        "node " + shell_quoted(ECHOMAP_LIVE_PAGE_PEERS "/foxglove_client.mjs") + " " +
            shell_quoted(url) + " 2 " + GetParam(),
        scratch.path());
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return json::parse(result.output, nullptr, false);
  }

  const tests::ScratchFolder scratch;
  FoxgloveTopics topics{"a run"};
};

TEST_P(FoxglovePeers, DecodeEveryTopicOfARunInItsOrder) {
  recording::SessionRecorder recorder({{}, {0.2, 0.04, 2.0}, {{0.1, 0.0, 0.0}}});
  recorder.listen(&topics);
  const PageServer server(params(), {}, nullptr);
  const std::jthread run([&](const std::stop_token& stop) { drive(recorder, stop); });
  const json heard = summary(server.url());
  ASSERT_TRUE(heard.is_object());
  EXPECT_EQ(heard.at("sub_protocol"), GetParam());
  EXPECT_EQ(heard.at("server_info").at("sessionId"), "a run");
  EXPECT_THAT(heard.at("decode_errors"), IsEmpty());
  EXPECT_THAT(heard.at("statuses"), IsEmpty());
  EXPECT_GT(heard.at("times"), 20);
  EXPECT_EQ(heard.at("times_back"), 0);
  for (const char* topic : {"/session/events",
                            "/odom",
                            "/tf",
                            "/tf_static",
                            "/sonar",
                            "/sonar/cone",
                            "/map",
                            "/path",
                            "/pose",
                            "/map/features",
                            "/rosout"}) {
    ASSERT_TRUE(heard.at("topics").contains(topic)) << topic;
    EXPECT_GE(heard.at("topics").at(topic).at("messages"), 1) << topic;
    EXPECT_EQ(heard.at("topics").at(topic).at("times_back"), 0) << topic;
  }
  EXPECT_GT(heard.at("topics").at("/odom").at("messages"), 20);
}

INSTANTIATE_TEST_SUITE_P(Names,
                         FoxglovePeers,
                         testing::Values("foxglove.websocket.v1", "foxglove.sdk.v1"),
                         [](const auto& name) { return std::string(name.param).substr(9, 3); });

}  // namespace
}  // namespace echomap::live_page
