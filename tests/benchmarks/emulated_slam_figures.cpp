// SPDX-License-Identifier: MIT
#include "tests/benchmarks/emulated_slam_figures.hpp"

#include <chrono>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/odometry.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/benchmarks/slam_run_figures.hpp"
#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_robot.hpp"
#include "tests/support/played_recording.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes kPatience(5);
constexpr const char* kBody = "uno_2wd_rough";

/// Where the wheels alone had the robot.
class OdometryPath final : public pipeline::ObservationSink {
 public:
  explicit OdometryPath(double track_m) : odometry_(track_m) {}

  void on_odometry(const sensors::OdometryObservation& observation) override {
    poses_.push_back({observation.stamp, odometry_.update(observation.travel)});
  }
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void begin_scan() override {}
  void end_scan() override {}

  const std::vector<pipeline::StampedPose>& poses() const { return poses_; }

 private:
  sensors::WheelOdometry odometry_;
  std::vector<pipeline::StampedPose> poses_;
};

std::vector<pipeline::StampedPose> odometry_of(const fs::path& run) {
  OdometryPath path(tests::assumed_geometry(tests::bundled_robot(kBody)).track_m);
  tests::play_recording(run / recording::kSessionFileName, path);
  return path.poses();
}

std::optional<SlamRun> explore(const std::string& room,
                               std::uint32_t seed,
                               const fs::path& folder) {
  const fs::path run = folder / (room + std::to_string(seed));
  session::ChildProcess demo({session::program_folder() / "echomap",
                              "demo",
                              "--headless",
                              "--no-kidnap",
                              "--world=" + room,
                              fmt::format("--body={}", kBody),
                              "--seed=" + std::to_string(seed),
                              "--out=" + run.string()},
                             run.string() + ".log");
  const auto status = demo.wait_for(kPatience);
  try {
    if (status != 0) {
      throw std::runtime_error("it did not end well");
    }
    const auto score = evaluation::score_run(run, run / "truth");
    const auto truth = evaluation::read_truth(run / "truth").trajectory;
    return SlamRun{score.trajectory,
                   evaluation::score_trajectory(odometry_of(run), truth),
                   score.start.map.free_iou};
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}, seed {}, has no score: {}\n", room, seed, error.what());
    return std::nullopt;
  }
}

}  // namespace

std::vector<Figure> emulated_slam_figures(std::uint32_t seeds) {
  const session::TemporaryFolder folder;
  std::vector<Figure> figures;
  for (const std::string room : {"living_room", "office", "corridor"}) {
    std::vector<SlamRun> runs;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
      if (const auto run = explore(room, seed, folder.path())) {
        runs.push_back(*run);
      }
    }
    const auto some = slam_run_figures("emulated_" + room, runs);
    figures.insert(figures.end(), some.begin(), some.end());
  }
  return figures;
}

}  // namespace echomap::bench
