// SPDX-License-Identifier: MIT
// Serves the live page of a run that no robot makes: a map of 1000 x 1000 cells, 5,000 particles
// and a robot that goes round, all of them anew 20 times a second. Prints the page's URL, ends by
// Ctrl-C.
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <thread>
#include <vector>

#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/pose2.hpp"
#include "host/live_page/page_server.hpp"
#include "host/live_page/run_publisher.hpp"
#include "host/mapping/grid_tile.hpp"

namespace echomap::live_page {
namespace {

using geometry::Pose2;
using mapping::kTileSide;

constexpr int kSide = 1000;
constexpr double kResolutionM = 0.05;
constexpr double kSideM = kSide * kResolutionM;
constexpr int kRoomCells = 100;
constexpr std::size_t kParticles = 5000;
constexpr std::chrono::milliseconds kPeriod(50);
constexpr double kPeriodS = 0.05;
constexpr double kRoundM = 15.0;
constexpr double kTurnRadPerS = 0.1;

/// Rooms of 5 m with walls between them, and doors.
std::uint8_t cell_at(std::int32_t x, std::int32_t y) {
  if (x >= kSide || y >= kSide) {
    return mapping::kUntouchedByte;
  }
  const auto in_room_x = x % kRoomCells;
  const auto in_room_y = y % kRoomCells;
  const bool is_wall = (in_room_x < 3 && in_room_y > 20) || (in_room_y < 3 && in_room_x > 20);
  return is_wall ? mapping::kEvenByte + 60 : mapping::kEvenByte - 60;
}

mapping::GridTile tile_at(geometry::CellIndex tile) {
  mapping::GridTile cells;
  for (std::int32_t y = 0; y < kTileSide; ++y) {
    for (std::int32_t x = 0; x < kTileSide; ++x) {
      cells.row(y)[x] = cell_at(kTileSide * tile.x + x, kTileSide * tile.y + y);
    }
  }
  return cells;
}

Pose2 pose_at(double time_s) {
  const double angle_rad = kTurnRadPerS * time_s;
  return {0.5 * kSideM + kRoundM * std::cos(angle_rad),
          0.5 * kSideM + kRoundM * std::sin(angle_rad),
          angle_rad + 0.5 * std::numbers::pi};
}

class SyntheticRun {
 public:
  SyntheticRun() : publisher_(history_, facts(), session::RobotProfile()) {
    constexpr std::int32_t kTiles = (kSide + kTileSide - 1) / kTileSide;
    for (std::int32_t y = 0; y < kTiles; ++y) {
      for (std::int32_t x = 0; x < kTiles; ++x) {
        history_->add(tile_message(0.0, {x, y}, tile_at({x, y})));
      }
    }
  }
  const std::shared_ptr<History>& history() const { return history_; }

  void tell(double time_s) {
    const Pose2 pose = pose_at(time_s);
    pipeline::PoseEstimate estimate{pose, pose, Eigen::Vector3d(0.04, 0.02, 0.01).asDiagonal()};
    particles_.clear();
    for (std::size_t i = 0; i < kParticles; ++i) {
      const Pose2 guess(pose.position_m().x() + spread_m_(random_),
                        pose.position_m().y() + spread_m_(random_),
                        pose.heading_rad() + spread_m_(random_));
      particles_.push_back({guess, 1.0 / kParticles});
    }
    publisher_.add_particles(time_s, particles_);
    const auto tile = [](double at_m) {
      return static_cast<std::int32_t>(at_m / (kResolutionM * kTileSide));
    };
    const geometry::CellIndex here{tile(pose.position_m().x()), tile(pose.position_m().y())};
    history_->add(tile_message(time_s, here, tile_at(here)));
    path_m_.push_back(pose.position_m());
    history_->add(trail_message(time_s, path_m_));
    publisher_.add_motion(time_s, estimate);
  }

 private:
  static RunFacts facts() {
    RunFacts facts;
    facts.name = "synthetic";
    facts.command = "explore";
    facts.live = true;
    return facts;
  }

  std::shared_ptr<History> history_ = std::make_shared<History>();
  RunPublisher publisher_;
  std::mt19937 random_{1};
  std::normal_distribution<double> spread_m_{0.0, 0.5};
  std::vector<WeightedPose> particles_;
  std::vector<Eigen::Vector2d> path_m_;
};

void serve() {
  SyntheticRun run;
  PageServerParams params;
  params.page_folder = files::bundled_folder("host/live_page/built_page");
  params.openapi_file = files::bundled_folder("host/live_page") / "openapi.json";
  const PageServer server(params, {{"synthetic", {}, run.history(), true}}, nullptr);
  console::print("live page: " + server.url());
  auto next = std::chrono::steady_clock::now();
  for (double time_s = 0.0; !console::interrupted(); time_s += kPeriodS) {
    run.tell(time_s);
    next += kPeriod;
    std::this_thread::sleep_until(next);
  }
}

}  // namespace
}  // namespace echomap::live_page

int main() {
  echomap::console::catch_interrupts();
  echomap::live_page::serve();
  return 0;
}
