// SPDX-License-Identifier: MIT
#include "hil_mock/runner/overhead_camera.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "host/geometry/angle.hpp"

namespace echomap::runner {
namespace {

constexpr double kSecondNs = 1e9;
/// A room is no darker than a second's exposure, and nobody waits for a fix longer than a minute.
constexpr double kMinHz = 1.0;
constexpr double kMaxHz = 1000.0;
constexpr double kLongestDelayS = 60.0;

const CameraParams& validated(const CameraParams& params) {
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  const bool times_ok = within(params.rate_hz, kMinHz, kMaxHz) &&
                        within(params.delay_s, 0.0, kLongestDelayS) &&
                        within(params.jitter_s, 0.0, kLongestDelayS);
  const bool noise_ok = within(params.noise_m, 0.0, 10.0) && within(params.noise_deg, 0.0, 180.0) &&
                        within(params.drop, 0.0, 1.0);
  if (!times_ok || !noise_ok) {
    throw std::invalid_argument(
        "a camera's rate is 1 to 1000 Hz, its delay and jitter 0 to 60 s, its noise 0 to 10 m and "
        "its heading's 0 to 180 degrees, drop 0 to 1");
  }
  return params;
}

double number_in(const std::string& part, const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
    throw std::invalid_argument("'" + part + "': expected a number");
  }
  return number;
}

std::int64_t nanoseconds(double duration_s) { return std::llround(duration_s * kSecondNs); }

}  // namespace

CameraParams parse_camera(const std::string& text) {
  CameraParams params;
  const std::map<std::string, double*> numbers{{"rate", &params.rate_hz},
                                               {"delay", &params.delay_s},
                                               {"jitter", &params.jitter_s},
                                               {"noise", &params.noise_m},
                                               {"heading", &params.noise_deg},
                                               {"drop", &params.drop}};
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    const auto number = numbers.find(part.substr(0, equals));
    if (number == numbers.end() || equals == std::string::npos) {
      throw std::invalid_argument("'" + part +
                                  "': expected rate, delay, jitter, noise, heading or drop, as in "
                                  "delay=0.1,noise=0.01,drop=0.2");
    }
    *number->second = number_in(part, part.substr(equals + 1));
  }
  return validated(params);
}

OverheadCamera::OverheadCamera(const CameraParams& params, std::uint32_t seed)
    : params_(validated(params)),
      noise_(seed, world::NoisePurpose::kCamera),
      period_ns_(nanoseconds(1.0 / params.rate_hz)) {}

std::vector<std::string> OverheadCamera::look(std::int64_t now_ns,
                                              const geometry::Pose2& T_world_robot) {
  if (now_ns >= next_picture_ns_) {
    take_picture(now_ns, T_world_robot);
    next_picture_ns_ += period_ns_;
  }
  std::vector<std::string> lines;
  while (!under_way_.empty() && under_way_.front().sent_ns <= now_ns) {
    lines.push_back(line_of(under_way_.front()));
    under_way_.pop_front();
  }
  return lines;
}

/// Draws the same numbers for every picture, so that a setting does not shift the others' noise.
void OverheadCamera::take_picture(std::int64_t now_ns, const geometry::Pose2& T_world_robot) {
  const bool is_dropped = noise_.uniform() < params_.drop;
  const double late_s = params_.delay_s + params_.jitter_s * noise_.uniform();
  const double x_m = T_world_robot.x_m() + params_.noise_m * noise_.normal();
  const double y_m = T_world_robot.y_m() + params_.noise_m * noise_.normal();
  const double heading_rad =
      T_world_robot.heading_rad() + geometry::radians(params_.noise_deg) * noise_.normal();
  if (is_dropped) {
    return;
  }
  const Fix fix{now_ns + nanoseconds(late_s), now_ns, {x_m, y_m, heading_rad}};
  const auto is_earlier = [](const Fix& a, const Fix& b) { return a.sent_ns < b.sent_ns; };
  under_way_.insert(std::upper_bound(under_way_.begin(), under_way_.end(), fix, is_earlier), fix);
}

std::string OverheadCamera::line_of(const Fix& fix) const {
  constexpr double kMinStddevM = 1e-3;
  constexpr double kMinStddevRad = 1e-3;
  const nlohmann::ordered_json json{
      {"stamp_s", static_cast<double>(fix.stamp_ns) / kSecondNs},
      {"sent_s", static_cast<double>(fix.sent_ns) / kSecondNs},
      {"x_m", fix.T_world_robot.x_m()},
      {"y_m", fix.T_world_robot.y_m()},
      {"heading_rad", fix.T_world_robot.heading_rad()},
      {"std_m", std::max(kMinStddevM, params_.noise_m)},
      {"std_rad", std::max(kMinStddevRad, geometry::radians(params_.noise_deg))}};
  return json.dump();
}

}  // namespace echomap::runner
