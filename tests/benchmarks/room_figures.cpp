// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_figures.hpp"

#include <fmt/format.h>

#include "host/geometry/angle.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/range_table_model.hpp"
#include "tests/benchmarks/room_runs.hpp"
#include "tests/support/expect_pose_estimate.hpp"

namespace echomap::bench {
namespace {

using localization::LocalizationStatus;
using localization::MonteCarloLocalizer;

constexpr int kStops = 10;

/// A robot and what is to find it.
struct Trial {
  RoomRobot robot;
  MonteCarloLocalizer localizer;
  int directions;

  Reliability& reliability;

  void listen() {
    localizer.update(robot.T_odom_robot(), robot.listen(directions));
    reliability.add(localizer.belief().lost_probability, !is_within(0.30, 20.0));
  }
  bool is_right() const { return is_within(0.15, 10.0); }
  bool is_within(double metres, double degrees) const {
    return tests::is_estimated_near(
        localizer.belief(), robot.T_map_robot(), metres, geometry::radians(degrees));
  }
  /// Drives on and listens; returns how often the robot was called lost.
  int go_on(int stops) {
    int lost = 0;
    for (int i = 0; i < stops; ++i) {
      robot.drive();
      listen();
      lost += localizer.belief().status == LocalizationStatus::kLost ? 1 : 0;
    }
    return lost;
  }
};

void run(Trial& trial, RoomScore& score) {
  ++score.starts;
  trial.listen();
  trial.go_on(kStops - 1);
  if (!trial.is_right()) {
    return;
  }
  ++score.found;
  score.alarms += trial.go_on(kStops);
  score.stops += kStops;
  trial.robot.be_carried_off();
  ++score.kidnapped;
  const bool is_noticed = trial.go_on(kStops) > 0;
  const bool is_right = trial.is_right();
  score.noticed += is_noticed || is_right ? 1 : 0;
  score.recovered += is_right ? 1 : 0;
}

void add(const RoomScore& more, RoomScore& all) {
  all.starts += more.starts;
  all.found += more.found;
  all.kidnapped += more.kidnapped;
  all.noticed += more.noticed;
  all.recovered += more.recovered;
  all.stops += more.stops;
  all.alarms += more.alarms;
}

Figure rate(const std::string& name, int part, int whole) {
  return {name, static_cast<double>(part) / whole, "1", static_cast<std::size_t>(whole), {}};
}

}  // namespace

RoomScore score_room(const std::string& room,
                     int directions,
                     int starts,
                     std::uint32_t seed,
                     Reliability& reliability) {
  localization::RangeTableModel model(localization::RangeTable(map_of_room(room), kSonar),
                                      models::BeamModel(models::sonar_cone_returns()));
  RoomScore score;
  for (int i = 0; i < starts; ++i) {
    const std::uint32_t own_seed = seed + static_cast<std::uint32_t>(i);
    Trial trial{RoomRobot(room, own_seed),
                MonteCarloLocalizer(model, {}, std::mt19937(own_seed)),
                directions,
                reliability};
    run(trial, score);
  }
  return score;
}

std::vector<Figure> room_figures(int starts,
                                 std::uint32_t seed,
                                 const std::filesystem::path& picture) {
  std::vector<Figure> figures;
  RoomScore both;
  Reliability reliability;
  for (const int directions : {8, 60}) {
    RoomScore all;
    for (const char* const room : {"living_room", "l_room", "playground", "landing", "office"}) {
      const RoomScore score = score_room(room, directions, starts, seed, reliability);
      fmt::print(
          "{:12} {:2} directions: found {} of {}; carried off {}, noticed {}, found again {}; {} "
          "false alarms at {} stops\n",
          room,
          directions,
          score.found,
          score.starts,
          score.kidnapped,
          score.noticed,
          score.recovered,
          score.alarms,
          score.stops);
      add(score, all);
    }
    figures.push_back(rate(fmt::format("global_success_{}", directions), all.found, all.starts));
    add(all, both);
  }
  figures.push_back(rate("kidnap_noticed", both.noticed, both.kidnapped));
  figures.push_back(rate("kidnap_recovered", both.recovered, both.kidnapped));
  figures.push_back(rate("false_alarms_per_stop", both.alarms, both.stops));
  figures.push_back(
      {"lost_probability_error", reliability.mean_error(), "1", reliability.count(), {}});
  if (!picture.empty()) {
    write_reliability_svg(reliability, picture);
  }
  return figures;
}

}  // namespace echomap::bench
