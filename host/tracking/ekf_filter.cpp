// SPDX-License-Identifier: MIT
#include "host/tracking/ekf_filter.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/console/print.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/tracking/pose_report.hpp"

namespace echomap::tracking {
namespace {

constexpr std::chrono::seconds kFixPatience(5);

using geometry::square;

Eigen::Matrix3d covariance_of(double stddev_m, double stddev_rad) {
  return Eigen::Vector3d(square(stddev_m), square(stddev_m), square(stddev_rad)).asDiagonal();
}

}  // namespace

EkfFilter::EkfFilter(const sensors::RobotGeometry& robot,
                     FixStream fixes,
                     const geometry::Pose2& T_map_camera,
                     const std::optional<StartPose>& start)
    : ekf_(robot), fixes_(std::move(fixes)), T_map_camera_(T_map_camera), start_(start) {}

void EkfFilter::poll(const session::RobotSession& session) {
  for (const TimedFix& fix : fixes_.take(session.now())) {
    if (ekf_.stamp()) {
      ekf_.add({stamp_s_of(fix.taken, session),
                T_map_camera_ * fix.fix.T_camera_robot,
                covariance_of(fix.fix.stddev_m, fix.fix.stddev_rad)});
    }
  }
  if (ekf_.times_lost() > losses_told_) {
    losses_told_ = ekf_.times_lost();
    was_lost_ = true;
    console::print(
        ekf_.belief()
            ? fmt::format(
                  "  pose measurements contradict the estimate (did a wheel slip, or was the "
                  "robot moved?): restarted at the one of {:.1f} s of robot time",
                  std::chrono::duration<double>(ekf_.stamp()->time_since_epoch()).count())
            : "  lost: the robot was lifted; restarting at the next measurement");
  }
  look_for_silence(session.now());
}

void EkfFilter::look_for_silence(time::HostTime now) {
  if (!silent_since_) {
    return;
  }
  if (ekf_.applied() > applied_) {
    applied_ = ekf_.applied();
    silent_since_ = now;
    silence_is_told_ = false;
  } else if (now - *silent_since_ >= kFixPatience && !std::exchange(silence_is_told_, true)) {
    spdlog::warn("{} has sent no usable pose for {} s; continuing on odometry alone",
                 fixes_.name(),
                 kFixPatience.count());
  }
}

/// The last odometry has one stamp of the robot's clock, which lies at a known instant of the
/// host's, and one that the filter goes by; from the one the other is reckoned.
double EkfFilter::stamp_s_of(time::HostTime instant, const session::RobotSession& session) const {
  const auto odometry_us = session.odometry_stamp_us();
  const auto estimate = odometry_us ? session.link().clock().host_time(*odometry_us) : std::nullopt;
  const time::HostTime sensed = estimate ? estimate->instant : session.now();
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): odometry came before
  const std::chrono::duration<double> stamp = ekf_.stamp()->time_since_epoch();
  return stamp.count() + std::chrono::duration<double>(instant - sensed).count();
}

void EkfFilter::begin(session::RobotSession& session) {
  if (start_) {
    ekf_.start_at({start_->T_map_robot, covariance_of(start_->stddev_m, start_->stddev_rad)});
  } else {
    wait_for_fix(session);
  }
  silent_since_ = session.now();
}

void EkfFilter::wait_for_fix(session::RobotSession& session) const {
  session.wait_until([this] { return ekf_.belief().has_value(); }, kFixPatience);
  if (!ekf_.belief() && !session.end()) {
    throw console::CommandError(
        console::ExitCode::kRuntimeError,
        fmt::format("no pose arrived from {} within {} s ({} malformed lines)\n"
                    "  next: start the camera, or give the start pose with --at",
                    fixes_.name(),
                    kFixPatience.count(),
                    fixes_.bad_lines()));
  }
}

bool EkfFilter::has_lost_it() { return std::exchange(was_lost_, false); }

std::string EkfFilter::line() const {
  const auto belief = ekf_.belief();
  if (!belief) {
    return "lost, no pose measurement since";
  }
  return fmt::format("{}, +- {:.1f} cm and {:.1f} degrees ({} pose measurements)",
                     text_of(belief->T_map_robot),
                     100.0 * std::sqrt(belief->covariance.topLeftCorner<2, 2>().trace()),
                     geometry::degrees(std::sqrt(belief->covariance(2, 2))),
                     ekf_.applied());
}

nlohmann::ordered_json EkfFilter::report() const {
  nlohmann::ordered_json json;
  const auto belief = ekf_.belief();
  json["status"] = belief ? "localized" : "lost";
  json["times_lost"] = ekf_.times_lost();
  json["fixes"] = {{"applied", ekf_.applied()},
                   {"gated", ekf_.gated()},
                   {"refused", ekf_.refused()},
                   {"bad_lines", fixes_.bad_lines()}};
  json["hypotheses"] = nlohmann::ordered_json::array();
  if (belief) {
    json["hypotheses"].push_back(to_json(belief->T_map_robot, belief->covariance));
  }
  return json;
}

}  // namespace echomap::tracking
