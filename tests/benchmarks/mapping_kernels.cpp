// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mapping_kernels.hpp"

#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/ray_casting.hpp"
#include "host/mapping/ray_insertion.hpp"
#include "tests/benchmarks/mapping_workloads.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

using geometry::Pose2;
using mapping::CellState;

double between(double low, double high, std::mt19937& random) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

Pose2 any_pose(double low_m, double high_m, std::mt19937& random) {
  const double x_m = between(low_m, high_m, random);
  const double y_m = between(low_m, high_m, random);
  return {x_m, y_m, between(-std::numbers::pi, std::numbers::pi, random)};
}

/// The contestants take turns; their medians, `work` units a second, as one figure.
Figure contest(const std::string& name,
               const std::string& unit,
               double work,
               std::size_t repetitions,
               std::vector<Contestant> contestants) {
  std::map<std::string, std::vector<double>> seconds;
  for (std::size_t i = 0; i <= repetitions; ++i) {
    for (const Contestant& contestant : contestants) {
      const double took_s = contestant.run_s();
      if (i > 0) {  // The first round warms up.
        seconds[contestant.name].push_back(took_s);
      }
    }
  }
  Figure figure{name, 0.0, unit, repetitions, {}};
  for (const auto& [who, took_s] : seconds) {
    const double rate = work / tests::median(took_s);
    (who.empty() ? figure.value : figure.peers[who]) = rate;
  }
  return figure;
}

std::vector<Contestant> against(std::function<double()> ours, std::vector<Contestant> peers) {
  peers.insert(peers.begin(), {"", std::move(ours)});
  return peers;
}

/// Walls without corners, 5 m off in the mean.
std::vector<LaserScan> laser_scans() {
  std::mt19937 random(1);
  std::vector<LaserScan> scans;
  for (int i = 0; i < 100; ++i) {
    LaserScan scan{any_pose(-2.0, 2.0, random), {}};
    const double phase = between(0.0, 6.0, random);
    for (std::size_t beam = 0; beam < kBeams; ++beam) {
      const double bearing_rad = beam_bearing_rad(beam);
      scan.ranges_m.push_back(static_cast<float>(5.0 + 1.5 * std::sin(3.0 * bearing_rad + phase) +
                                                 0.5 * std::sin(11.0 * bearing_rad)));
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

Figure rays(std::size_t repetitions) {
  const auto scans = laser_scans();
  std::vector<Eigen::Vector2d> directions;
  for (std::size_t beam = 0; beam < kBeams; ++beam) {
    directions.push_back(geometry::unit_vector(beam_bearing_rad(beam)));
  }
  mapping::OccupancyGrid grid({.resolution_m = kResolutionM});
  mapping::RayInserter inserter;
  std::vector<mapping::Ray> ends(kBeams);
  const auto ours = [&] {
    return processor_seconds([&] {
      for (const LaserScan& scan : scans) {
        for (std::size_t beam = 0; beam < kBeams; ++beam) {
          ends[beam] = {static_cast<double>(scan.ranges_m[beam]) * directions[beam], true};
        }
        inserter.insert(scan.T_map_sensor, ends, grid);
      }
    });
  };
  const double beams = static_cast<double>(scans.size() * kBeams);
  return contest(
      "rays_5m_mbeams", "Mbeam/s", beams / 1e6, repetitions, against(ours, ray_peers(scans)));
}

/// A walled square with boxes of up to `largest` cells standing about.
mapping::RasterMap hall(int side, int boxes, std::uint32_t largest, std::uint32_t seed) {
  std::mt19937 random(seed);
  mapping::RasterMap map(side, side, kResolutionM, {0.0, 0.0});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool is_wall = x == 0 || y == 0 || x == side - 1 || y == side - 1;
      map.set({x, y}, is_wall ? CellState::kOccupied : CellState::kFree);
    }
  }
  for (int box = 0; box < boxes; ++box) {
    const auto room = static_cast<std::uint32_t>(side) - largest;
    const auto left = static_cast<int>(random() % room);
    const auto bottom = static_cast<int>(random() % room);
    const auto columns = static_cast<int>(1 + random() % largest);
    const auto rows = static_cast<int>(1 + random() % largest);
    for (int y = bottom; y < bottom + rows; ++y) {
      for (int x = left; x < left + columns; ++x) {
        map.set({x, y}, CellState::kOccupied);
      }
    }
  }
  return map;
}

Figure distances(std::size_t repetitions) {
  constexpr int kSide = 2000;
  const mapping::RasterMap map = hall(kSide, 300, 16, 3);
  mapping::DistanceField field(map, 1e3);
  const auto ours = [&] {
    return processor_seconds([&] { field.update(map, {{0, 0}, {kSide - 1, kSide - 1}}); });
  };
  return contest("distance_field_mcells",
                 "Mcell/s",
                 kSide * kSide / 1e6,
                 repetitions,
                 against(ours, distance_peers(map)));
}

/// Of a field that is bounded at 2 m, after a change somewhere in one tile.
Figure tile_updates(std::size_t repetitions) {
  const mapping::RasterMap map = hall(500, 60, 16, 4);
  mapping::DistanceField field(map, 2.0);
  std::vector<double> seconds;
  for (std::size_t i = 0; i < repetitions; ++i) {
    seconds.push_back(processor_seconds([&] { field.update(map, {{192, 192}, {255, 255}}); }));
  }
  return {"distance_field_tile_us", 1e6 * tests::median(seconds), "us", repetitions, {}};
}

Figure casts(std::size_t repetitions) {
  CastWorkload workload{hall(160, 30, 8, 5), {}};
  const mapping::DistanceField field(workload.map, kMaxCastM);
  std::mt19937 random(6);
  while (workload.places.size() < 200) {
    const Pose2 place = any_pose(0.5, 7.5, random);
    if (field.distance_cells(workload.map.cell_at(place.position_m())) > 3.0F) {
      workload.places.push_back(place);
    }
  }
  std::vector<Eigen::Vector2f> directions;
  for (std::size_t beam = 0; beam < kBeams; ++beam) {
    directions.push_back(geometry::unit_vector(beam_bearing_rad(beam)).cast<float>());
  }
  std::vector<float> ranges_m(kBeams);
  const auto ours = [&] {
    return processor_seconds([&] {
      for (const Pose2& place : workload.places) {
        mapping::cast_rays(field, place.position_m(), directions, kMaxCastM, ranges_m);
      }
    });
  };
  const double count = static_cast<double>(workload.places.size() * kBeams);
  return contest(
      "raycast_mrays", "Mray/s", count / 1e6, repetitions, against(ours, cast_peers(workload)));
}

}  // namespace

std::vector<Figure> kernel_figures(std::size_t repetitions) {
  return {rays(repetitions),
          distances(repetitions),
          tile_updates(100 * repetitions),
          casts(repetitions)};
}

}  // namespace echomap::bench
