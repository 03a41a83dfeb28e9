// SPDX-License-Identifier: MIT
#include "host/apps/demo_kidnap.hpp"

#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/localize_run.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/geometry/angle.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/tracking/mcl_filter.hpp"

namespace echomap::apps {
namespace {

constexpr std::size_t kMaxSearchStops = 10;
/// So many stops in a row that are sure of the place.
constexpr int kSureStops = 2;
constexpr std::chrono::seconds kHeld(2);
/// An explorer's own pose at the end.
constexpr double kStartStddevM = 0.1;
constexpr double kStartStddevRad = 0.1;

/// Drives on until the place is sure.
void go_on(const FollowedRobot& followed, tracking::MclFilter& filter, DemoKidnap& kidnap) {
  int sure_stops = 0;
  while (kidnap.stops < kMaxSearchStops && sure_stops < kSureStops &&
         follow_to_next_stop(followed)) {
    ++kidnap.stops;
    const auto status = filter.localizer().belief().status;
    kidnap.is_noticed = kidnap.is_noticed || status == localization::LocalizationStatus::kLost ||
                        filter.localizer().times_lifted() > 0;
    const bool is_sure =
        kidnap.is_noticed && status == localization::LocalizationStatus::kLocalized;
    sure_stops = is_sure ? sure_stops + 1 : 0;
  }
  if (sure_stops > 0) {
    kidnap.found = filter.trajectory().back();
  }
}

}  // namespace

DemoKidnap show_kidnap(session::RobotContext& robot, const std::string& slam) {
  const auto snapshot = robot.atlas().pipeline().snapshot();
  const session::RobotProfile& profile = robot.profile();
  tracking::MclFilter filter(
      mapping::rasterize(*snapshot.grid),
      profile.geometry,
      tracking::localizer_params(profile, localization::LocalizerPreset::kDefault),
      tracking::StartPose{snapshot.latest.T_map_robot, kStartStddevM, kStartStddevRad},
      robot.seed().generator(session::SeedPurpose::kLocalizer));
  robot.fork().add(filter.sink());
  tracking::StopDriver driver(robot, slam);
  const FollowedRobot followed{robot.session(), driver, filter};
  DemoKidnap kidnap;
  kidnap.start = snapshot.trajectory->front();

  console::print("localizing in its own map:");
  filter.begin(robot.session());
  if (follow_to_next_stop(followed)) {
    robot.lockstep()->carry_off(kHeld);
    console::print("carried to another place:");
    go_on(followed, filter, kidnap);
  }
  robot.session().disarm();
  robot.fork().remove(filter.sink());
  return kidnap;
}

nlohmann::ordered_json kidnap_report(const DemoKidnap& kidnap,
                                     const std::vector<evaluation::TruePose>& truth) {
  constexpr double kFoundM = 0.15;
  const double found_rad = geometry::radians(10.0);
  nlohmann::ordered_json json{{"noticed", kidnap.is_noticed},
                              {"found", false},
                              {"stops", kidnap.stops},
                              {"error_m", nullptr},
                              {"heading_error_rad", nullptr}};
  if (kidnap.found) {
    const auto error = evaluation::score_trajectory({kidnap.start, *kidnap.found}, truth);
    const double off_rad = std::abs(error.final_heading_error_rad);
    json["found"] = error.final_error_m <= kFoundM && off_rad <= found_rad;
    json["error_m"] = error.final_error_m;
    json["heading_error_rad"] = off_rad;
  }
  return json;
}

std::string kidnap_line(const nlohmann::ordered_json& report) {
  const auto stops = report.at("stops").get<std::size_t>();
  if (report.at("error_m").is_null()) {
    return fmt::format("carried off: not relocalized within {} stops", stops);
  }
  const bool is_found = report.at("found").get<bool>();
  return fmt::format("carried off: after {} stops it {}, {:.0f} cm off",
                     stops,
                     is_found ? "was relocalized" : "converged to a wrong pose",
                     100.0 * report.at("error_m").get<double>());
}

}  // namespace echomap::apps
