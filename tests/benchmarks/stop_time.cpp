// SPDX-License-Identifier: MIT
#include "tests/benchmarks/stop_time.hpp"

#include <chrono>
#include <numbers>
#include <vector>

#include "host/mapping/sonar_mapper.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::bench {
namespace {

constexpr double kHalfHallM = 15.0;
constexpr double kPostsApartM = 2.5;
/// Of an HC-SR04.
constexpr double kMaxRangeM = 4.0;
/// Stops are on a lattice, row by row: each has others next to it that have met the same walls.
constexpr std::size_t kStopsInARow = 32;
constexpr double kStopsApartM = 0.92;

tests::SmoothRoom hall_with_posts() {
  tests::SmoothRoom hall;
  for (int side = 0; side < 4; ++side) {
    hall.walls.push_back({side * std::numbers::pi / 2.0, kHalfHallM});
  }
  for (double x_m = kPostsApartM / 2.0 - kHalfHallM; x_m < kHalfHallM; x_m += kPostsApartM) {
    for (double y_m = kPostsApartM / 2.0 - kHalfHallM; y_m < kHalfHallM; y_m += kPostsApartM) {
      hall.corners_m.emplace_back(x_m, y_m);
    }
  }
  return hall;
}

std::vector<mapping::Scan> scans_of(std::size_t stops) {
  const tests::SmoothRoom hall = hall_with_posts();
  const double first_m = -0.5 * kStopsApartM * static_cast<double>(kStopsInARow - 1);
  std::vector<mapping::Scan> scans;
  for (std::size_t i = 0; i < stops; ++i) {
    const auto column = static_cast<double>(i % kStopsInARow);
    const auto row = static_cast<double>(i / kStopsInARow);
    mapping::Scan scan =
        tests::scan_of(hall, {first_m + kStopsApartM * column, first_m + kStopsApartM * row});
    for (auto& reading : scan) {
      if (reading.range_m && *reading.range_m > kMaxRangeM) {
        reading.range_m.reset();
      }
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

}  // namespace

double stop_ms(std::size_t stops) {
  std::vector<mapping::Scan> scans = scans_of(stops + 1);
  mapping::Scan last = std::move(scans.back());
  scans.pop_back();
  mapping::SonarMapper mapper;
  mapper.take(scans, {});
  mapper.grid();
  scans.push_back(std::move(last));
  const auto begin = std::chrono::steady_clock::now();
  mapper.take(scans, {});
  mapper.grid();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  return taken.count();
}

}  // namespace echomap::bench
