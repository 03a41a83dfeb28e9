// SPDX-License-Identifier: MIT
#include "host/papers/patch_figures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace echomap::papers {
namespace {

/// Confidence of one echo in the middle of a cell.
constexpr float kOccupied = 1.0F;
/// Open floor is farther than this from all that stands: patches of good echoes end before.
constexpr double kOpenFloorM = 0.2;
constexpr double kFoundM = 0.05;

bool on_known_wall(const Playground& playground, const Eigen::Vector2d& point_m) {
  const auto& walls = playground.known_walls;
  return std::any_of(walls.begin(), walls.end(), [&](const geometry::Segment& wall) {
    return geometry::distance_m(wall, point_m) < 1e-6;
  });
}

/// The way to the door is neither wall nor box.
bool on_box(const Playground& playground, const Eigen::Vector2d& point_m) {
  return !on_known_wall(playground, point_m) && point_m.y() > 0.3;
}

/// Points along the walls for which `chosen` holds, a centimetre apart.
template <typename Chooser>
std::vector<Eigen::Vector2d> wall_points_m(const Playground& playground, Chooser&& chosen) {
  std::vector<Eigen::Vector2d> points_m;
  for (const world::Wall& wall : playground.for_sonar.walls()) {
    const Eigen::Vector2d offset_m = wall.segment.to_m - wall.segment.from_m;
    const int steps = static_cast<int>(std::lround(offset_m.norm() / 0.01));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d point_m = wall.segment.from_m + (i + 0.5) / steps * offset_m;
      if (chosen(playground, point_m)) {
        points_m.push_back(point_m);
      }
    }
  }
  return points_m;
}

double found_share(const std::vector<Eigen::Vector2d>& points_m,
                   const std::vector<Eigen::Vector2d>& occupied_m) {
  const auto found = std::count_if(points_m.begin(), points_m.end(), [&](const auto& point_m) {
    return std::any_of(occupied_m.begin(), occupied_m.end(), [&](const auto& center_m) {
      return (center_m - point_m).norm() <= kFoundM;
    });
  });
  return static_cast<double>(found) / static_cast<double>(points_m.size());
}

double distance_rms_m(const Playground& playground, const std::vector<Eigen::Vector2d>& points_m) {
  double squares = 0.0;
  for (const auto& point_m : points_m) {
    squares += std::pow(playground.for_bumper.clearance_m(point_m), 2);
  }
  return std::sqrt(squares / static_cast<double>(points_m.size()));
}

double open_floor_wrong(const Playground& playground, const mapping::CellField& field) {
  int open = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Eigen::Vector2d center_m = field.center_m(field.cell(i));
    if (playground.for_bumper.is_free(center_m) &&
        playground.for_bumper.clearance_m(center_m) > kOpenFloorM) {
      ++open;
      wrong += field[i] >= kOccupied;
    }
  }
  return static_cast<double>(wrong) / open;
}

}  // namespace

PatchFigures patch_figures(const Playground& playground, const PatchDrive& drive) {
  const mapping::CellField& field = drive.confidence;
  std::vector<Eigen::Vector2d> occupied_m;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] >= kOccupied) {
      occupied_m.push_back(field.center_m(field.cell(i)));
    }
  }
  PatchFigures figures;
  figures.walls_found = found_share(wall_points_m(playground, on_known_wall), occupied_m);
  figures.boxes_found = found_share(wall_points_m(playground, on_box), occupied_m);
  figures.occupied_rms_m = distance_rms_m(playground, occupied_m);
  figures.echo_rms_m = distance_rms_m(playground, drive.echoes_m);
  figures.open_floor_wrong = open_floor_wrong(playground, field);
  figures.block = field[field.index(field.cell_at({1.49, 1.84}))];
  figures.final_error_m = drive.final_error_m;
  return figures;
}

}  // namespace echomap::papers
