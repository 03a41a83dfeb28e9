// SPDX-License-Identifier: MIT
#include "tests/benchmarks/wean_figures.hpp"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "host/datasets/open_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/robot_localizer.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/expect_pose_estimate.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/played_log.hpp"
#include "tests/support/real_data.hpp"
#include "tests/support/wean_map.hpp"

namespace echomap::bench {
namespace {

constexpr int kSeeds = 10;

struct Drive {
  int number;
  geometry::Pose2 T_map_end;  ///< As the data's README gives it.
  double lasts_s;
};

const std::array<Drive, 3> kDrives{{{1, {40.00, 41.51, 1.32}, 135.0},
                                    {3, {39.75, 40.01, -0.05}, 132.0},
                                    {4, {40.13, 40.91, 1.45}, 64.0}}};

void say(const Drive& drive, std::uint32_t seed, const localization::PoseBelief& belief) {
  const geometry::Pose2 off = drive.T_map_end.inverse() * belief.hypotheses.at(0).T_map_robot;
  fmt::print("wean {} seed {}: off by {:.2f} m, {:.1f} deg; lost probability {:.2f}\n",
             drive.number,
             seed,
             off.position_m().norm(),
             geometry::degrees(off.heading_rad()),
             belief.lost_probability);
}

}  // namespace

std::vector<Figure> wean_figures(std::uint32_t seed, bool verbose) {
  const auto folder = tests::real_data("wean_mcl");
  if (!std::filesystem::exists(folder)) {
    fmt::print("wean: not there, skipped\n");
    return {};
  }
  const mapping::RasterMap map = tests::read_wean_map(folder / "wean.dat.gz");
  int found = 0;
  double seconds = 0.0;
  double lasted_s = 0.0;
  for (const Drive& drive : kDrives) {
    const auto records = tests::records_of(
        *datasets::open_log(folder / fmt::format("robotdata{}.log.gz", drive.number), "wean"));
    for (std::uint32_t own_seed = seed; own_seed < seed + kSeeds; ++own_seed) {
      pipeline::RobotLocalizer localizer(map, {}, {}, std::mt19937(own_seed));
      seconds += processor_seconds([&] { tests::play(records, localizer); });
      lasted_s += drive.lasts_s;
      const localization::PoseBelief& belief = localizer.belief();
      found +=
          tests::is_estimated_near(belief, drive.T_map_end, 0.30, geometry::radians(5.0)) ? 1 : 0;
      if (verbose) {
        say(drive, own_seed, belief);
      }
    }
  }
  constexpr std::size_t kRuns = kDrives.size() * kSeeds;
  return {{"wean_success_of_30", static_cast<double>(found), "runs", kRuns, {}},
          {"wean_times_real_time", lasted_s / seconds, "1", kRuns, {}}};
}

}  // namespace echomap::bench
