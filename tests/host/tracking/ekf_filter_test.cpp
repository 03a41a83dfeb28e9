// SPDX-License-Identifier: MIT
#include "host/tracking/ekf_filter.hpp"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "tests/host/session/session_on_a_cable.hpp"
#include "tests/host/tracking/told_stream.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::tracking {
namespace {

using ::testing::HasSubstr;

/// A robot that stands under a camera, whose frame the map has at (1, 0), a quarter turned.
class EkfFilterTest : public session::SessionOnACable {
 protected:
  std::unique_ptr<EkfFilter> connect(const std::optional<StartPose>& start) {
    auto filter = std::make_unique<EkfFilter>(profile.geometry,
                                              FixStream(std::make_unique<tests::ToldStream>(bytes)),
                                              geometry::Pose2(1.0, 0.0, geometry::radians(90.0)),
                                              start);
    fork.add(filter->sink());
    session = std::make_unique<session::RobotSession>(new_connection(), profile, fork);
    session->connect();
    session->on_step = [this, raw = filter.get()] { raw->poll(*session); };
    return filter;
  }
  void let_pass(int ms) {
    session->wait_until([] { return false; }, std::chrono::milliseconds(ms));
  }

  std::string bytes;
  pipeline::ObservationFork fork;
};

constexpr const char* kFix =
    "{\"stamp_s\": 70.0, \"sent_s\": 70.1, \"x_m\": 2, \"y_m\": 0, \"heading_rad\": 0}\n";

TEST_F(EkfFilterTest, StartsWithTheFirstFixInTheMapsFrame) {
  const auto filter = connect(std::nullopt);
  EXPECT_THAT(filter->line(), HasSubstr("lost"));
  bytes = std::string("nonsense\n") + kFix;
  filter->begin(*session);
  const auto report = filter->report();
  EXPECT_NEAR(report.at("hypotheses").at(0).at("x_m").get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(report.at("hypotheses").at(0).at("y_m").get<double>(), 2.0, 1e-6);
  EXPECT_EQ(report.at("fixes").at("applied"), 1);
  EXPECT_EQ(report.at("fixes").at("bad_lines"), 1);
  EXPECT_THAT(filter->line(), HasSubstr("1.00, 2.00 m, 90 degrees"));
}

TEST_F(EkfFilterTest, PutsAFixWhereItBelongs) {
  const auto filter = connect(std::nullopt);
  let_pass(3000);
  bytes = kFix;
  let_pass(200);
  bytes = "{\"stamp_s\": 60.0, \"sent_s\": 70.3, \"x_m\": 2, \"y_m\": 0, \"heading_rad\": 0}\n";
  let_pass(20);
  EXPECT_EQ(filter->report().at("fixes").at("refused"), 1) << "of ten seconds ago";
  bytes = "{\"stamp_s\": 70.25, \"sent_s\": 70.3, \"x_m\": 2, \"y_m\": 0, \"heading_rad\": 0}\n";
  let_pass(20);
  EXPECT_EQ(filter->report().at("fixes").at("applied"), 2);
}

TEST_F(EkfFilterTest, SaysThatNoFixComes) {
  const auto filter = connect(std::nullopt);
  bytes = "what?\nwhat?\n";
  const auto text = tests::thrown_text<console::CommandError>([&] { filter->begin(*session); });
  EXPECT_THAT(text, HasSubstr("no pose arrived from udp://camera"));
  EXPECT_THAT(text, HasSubstr("2 malformed lines"));
  EXPECT_THAT(text, HasSubstr("next: "));
}

TEST_F(EkfFilterTest, GoesByOdometryFromWhereTheUserSays) {
  const auto filter = connect(StartPose{{0.5, 0.25, 0.0}});
  EXPECT_NO_THROW(filter->begin(*session));
  let_pass(100);
  EXPECT_THAT(filter->line(), HasSubstr("0.50, 0.25 m"));
  EXPECT_FALSE(filter->has_lost_it());
}

TEST_F(EkfFilterTest, WarnsOnceOfACameraThatIsSilent) {
  const auto filter = connect(StartPose{{1.0, 2.0, geometry::radians(90.0)}});
  std::ostringstream said;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(std::make_shared<spdlog::logger>(
      "test", std::make_shared<spdlog::sinks::ostream_sink_st>(said)));
  filter->begin(*session);
  let_pass(4000);
  bytes = kFix;
  let_pass(4900);
  EXPECT_EQ(said.str(), "");
  let_pass(10'000);
  spdlog::set_default_logger(before);
  const std::string text = said.str();
  EXPECT_THAT(text, HasSubstr("udp://camera has sent no usable pose for 5 s"));
  EXPECT_EQ(text.find("no usable pose"), text.rfind("no usable pose"));
}

TEST_F(EkfFilterTest, SaysWhenMeasurementsContradictTheEstimate) {
  const auto filter = connect(std::nullopt);
  let_pass(3000);
  bytes = kFix;
  let_pass(200);
  ::testing::internal::CaptureStderr();
  for (int i = 0; i < 20; ++i) {
    bytes = fmt::format(
        R"({{"stamp_s": {0:.1f}, "sent_s": {0:.1f}, "x_m": 9, "y_m": 9, "heading_rad": 2}})"
        "\n",
        70.3 + 0.1 * i);
    let_pass(100);
  }
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("pose measurements contradict the estimate"));
  EXPECT_EQ(said.find("contradict"), said.rfind("contradict")) << said;
  EXPECT_EQ(said.find("lost"), std::string::npos) << said;
}

TEST_F(EkfFilterTest, HasLostALiftedRobotUntilTheNextFix) {
  const auto filter = connect(StartPose{{0.5, 0.25, 0.0}});
  filter->begin(*session);
  sensors::HazardObservation hazards;
  hazards.lifted = true;
  filter->sink().on_hazards(hazards);
  filter->poll(*session);
  EXPECT_TRUE(filter->has_lost_it());
  EXPECT_FALSE(filter->has_lost_it());
  EXPECT_EQ(filter->report().at("status"), "lost");
}

}  // namespace
}  // namespace echomap::tracking
