// SPDX-License-Identifier: MIT
#include "hil_mock/runner/overhead_camera.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/simulated_time.hpp"

namespace echomap::runner {
namespace {

using tests::kMs;

/// What a camera sends in so many seconds, of a robot that stands at (1, 2).
std::vector<nlohmann::json> fixes_of(const CameraParams& params,
                                     int seconds,
                                     std::uint32_t seed = 1) {
  OverheadCamera camera(params, seed);
  std::vector<nlohmann::json> fixes;
  for (std::int64_t now_ns = 0; now_ns < seconds * 1000 * kMs; now_ns += kMs) {
    for (const std::string& line : camera.look(now_ns, {1.0, 2.0, 0.5})) {
      fixes.push_back(nlohmann::json::parse(line));
      EXPECT_NEAR(fixes.back().at("sent_s").get<double>(), 1e-9 * double(now_ns), 1e-3);
    }
  }
  return fixes;
}

TEST(OverheadCamera, SendsPicturesLateWithTheNoiseThatItTells) {
  const auto fixes = fixes_of({}, 100);
  EXPECT_NEAR(double(fixes.size()), 999.0, 1.0);
  double squares_m2 = 0.0;
  for (const auto& fix : fixes) {
    EXPECT_NEAR(fix.at("sent_s").get<double>() - fix.at("stamp_s").get<double>(), 0.1, 1e-9);
    squares_m2 += std::pow(fix.at("x_m").get<double>() - 1.0, 2);
  }
  EXPECT_NEAR(std::sqrt(squares_m2 / double(fixes.size())), 0.01, 0.001);
  EXPECT_EQ(fixes[0].at("std_m"), 0.01);
}

TEST(OverheadCamera, DropsPicturesAndLetsFixesOvertakeEachOther) {
  CameraParams params;
  params.drop = 0.2;
  params.jitter_s = 0.3;
  const auto fixes = fixes_of(params, 100);
  EXPECT_NEAR(double(fixes.size()), 800.0, 50.0);
  int overtaken = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    overtaken += fixes[i].at("stamp_s") < fixes[i - 1].at("stamp_s") ? 1 : 0;
  }
  EXPECT_GT(overtaken, 100);
}

TEST(OverheadCamera, IsAFunctionOfItsSeed) {
  EXPECT_EQ(fixes_of({}, 3, 4), fixes_of({}, 3, 4));
  EXPECT_NE(fixes_of({}, 3, 4), fixes_of({}, 3, 5));
  CameraParams dropping;
  dropping.drop = 0.5;
  EXPECT_EQ(fixes_of(dropping, 3, 4).back().at("std_m"), fixes_of({}, 3, 4).back().at("std_m"));
}

TEST(OverheadCamera, IsReadFromText) {
  const CameraParams params =
      parse_camera("rate=25,delay=0.2,jitter=0.05,noise=0.03,heading=2,drop=0.4");
  EXPECT_EQ(params.rate_hz, 25.0);
  EXPECT_EQ(params.delay_s, 0.2);
  EXPECT_EQ(params.jitter_s, 0.05);
  EXPECT_EQ(params.noise_m, 0.03);
  EXPECT_EQ(params.noise_deg, 2.0);
  EXPECT_EQ(params.drop, 0.4);
  EXPECT_EQ(parse_camera("").rate_hz, CameraParams().rate_hz);
  for (const char* wrong : {"speed=1",
                            "rate",
                            "rate=",
                            "rate=x",
                            "rate=0",
                            "rate=nan",
                            "drop=2",
                            "noise=-1",
                            "delay=1e9"}) {
    EXPECT_THROW(parse_camera(wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace echomap::runner
