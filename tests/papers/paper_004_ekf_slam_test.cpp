// SPDX-License-Identifier: MIT
// Akzhalova and Polichshuk: EKF-SLAM on the Edmonton log. The paper prints a map (figure 2) and no
// number; scored here are the known ways between the log's scans (data/slam_relations).
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "host/evaluation/relation_error.hpp"
#include "host/exports/map_view.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/landmark_slam.hpp"
#include "tests/benchmarks/edmonton_slam.hpp"
#include "tests/benchmarks/turn_first_odometry.hpp"

namespace echomap::papers {
namespace {

using geometry::Pose2;

const std::filesystem::path edmonton_picture = ECHOMAP_BINARY_DIR "/papers/paper_004_edmonton.png";
constexpr double kPictureCellM = 0.15;
constexpr double kMaxDrawnM = 20.0;
constexpr double kGutterM = 3.0;

const slam::LandmarkSlam& slam_of(const bench::EdmontonLog& log) {
  static const auto done = [&] {
    auto method = std::make_unique<slam::LandmarkSlam>();
    bench::run_edmonton(log, *method);
    return method;
  }();
  return *done;
}

evaluation::RelationError told(const char* what, const evaluation::RelationError& error) {
  std::cout << what << ": " << error.translation_mean_m << " +- " << error.translation_stddev_m
            << " m, " << geometry::degrees(error.rotation_mean_rad) << " +- "
            << geometry::degrees(error.rotation_stddev_rad) << " deg\n";
  return error;
}

TEST(Paper004, DeadReckoningByItsEquationsDrifts) {
  const auto log = bench::read_edmonton();
  if (!log) {
    GTEST_SKIP() << "the Edmonton log is not here";
  }
  const auto error = told("equations 1 to 3",
                          evaluation::score_relations(bench::paper_odometry(*log), log->relations));

  EXPECT_GT(error.translation_mean_m, 0.25);
  EXPECT_GT(geometry::degrees(error.rotation_mean_rad), 2.0);
}

TEST(Paper004, EkfSlamErrsByAThirdOfOdometry) {
  const auto log = bench::read_edmonton();
  if (!log) {
    GTEST_SKIP() << "the Edmonton log is not here";
  }
  const auto error =
      told("EKF-SLAM", evaluation::score_relations(slam_of(*log).trajectory(), log->relations));

  EXPECT_LT(error.translation_mean_m, 0.10) << "odometry: 0.262";
  EXPECT_LT(geometry::degrees(error.rotation_mean_rad), 1.2) << "odometry: 2.20";
  EXPECT_GT(slam_of(*log).filter().landmarks().size(), 100U);
}

/// Ends of beams, by equations 4 to 6 from given poses.
std::vector<Eigen::Vector2d> scanned_points_m(const bench::EdmontonLog& log,
                                              const std::vector<Pose2>& T_map_scans) {
  std::vector<Eigen::Vector2d> points_m;
  std::size_t index = 0;
  for (const datasets::LogRecord& record : log.records) {
    const auto* scan = std::get_if<sensors::RangeScan>(&record);
    if (scan == nullptr) {
      continue;
    }
    for (const sensors::Beam& beam : scan->beams) {
      if (beam.range_m && *beam.range_m < kMaxDrawnM) {
        points_m.push_back(
            bench::scanned_point_m(T_map_scans[index], *beam.range_m, beam.bearing_rad));
      }
    }
    ++index;
  }
  return points_m;
}

/// A side of the picture: cells in which beams ended often are dark.
class Panel {
 public:
  Panel(const std::vector<Eigen::Vector2d>& points_m, const std::vector<Pose2>& T_map_scans)
      : T_map_scans_(&T_map_scans) {
    min_m_ = points_m.front();
    max_m_ = points_m.front();
    for (const Eigen::Vector2d& point_m : points_m) {
      min_m_ = min_m_.cwiseMin(point_m);
      max_m_ = max_m_.cwiseMax(point_m);
    }
    columns_ = static_cast<int>((max_m_.x() - min_m_.x()) / kPictureCellM) + 1;
    rows_ = static_cast<int>((max_m_.y() - min_m_.y()) / kPictureCellM) + 1;
    ends_.resize(static_cast<std::size_t>(columns_ * rows_));
    for (const Eigen::Vector2d& point_m : points_m) {
      const Eigen::Vector2i cell = ((point_m - min_m_) / kPictureCellM).cast<int>();
      ++ends_[static_cast<std::size_t>(cell.y() * columns_ + cell.x())];
    }
  }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  void draw(int first_column, mapping::RasterMap& map) const {
    constexpr int kMinEnds = 3;
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        const bool is_wall = ends_[static_cast<std::size_t>(y * columns_ + x)] >= kMinEnds;
        map.set({first_column + x, y},
                is_wall ? mapping::CellState::kOccupied : mapping::CellState::kFree);
      }
    }
  }
  /// A point of this side in the picture's map.
  Eigen::Vector2d place_m(int first_column, const Eigen::Vector2d& point_m) const {
    return point_m - min_m_ + Eigen::Vector2d(first_column * kPictureCellM, 0.0);
  }
  void draw_path(int first_column, const exports::MapView& view, exports::Picture& picture) const {
    for (std::size_t i = 1; i < T_map_scans_->size(); ++i) {
      picture.draw_line(view.place(place_m(first_column, (*T_map_scans_)[i - 1].position_m())),
                        view.place(place_m(first_column, (*T_map_scans_)[i].position_m())),
                        1.0,
                        exports::kGreen);
    }
  }

 private:
  const std::vector<Pose2>* T_map_scans_;
  Eigen::Vector2d min_m_;
  Eigen::Vector2d max_m_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> ends_;
};

void draw_landmarks(const slam::LandmarkSlam& method,
                    const Panel& panel,
                    int first_column,
                    const exports::MapView& view,
                    exports::Picture& picture) {
  for (const slam::Landmark& landmark : method.filter().landmarks()) {
    if (landmark.kind == slam::LandmarkKind::kPoint) {
      picture.fill_disc(
          view.place(panel.place_m(first_column, landmark.value)), 2.5, exports::kBlue);
      continue;
    }
    const Eigen::Vector2d normal = geometry::unit_vector(landmark.value.y());
    const Eigen::Vector2d foot_m = landmark.value.x() * normal;
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    picture.draw_line(
        view.place(panel.place_m(first_column, foot_m + landmark.along_from_m * along)),
        view.place(panel.place_m(first_column, foot_m + landmark.along_to_m * along)),
        1.5,
        exports::kVermilion);
  }
}

TEST(Paper004, MapIsDrawn) {
  const auto log = bench::read_edmonton();
  if (!log) {
    GTEST_SKIP() << "the Edmonton log is not here";
  }
  const auto T_odom_scans = bench::paper_odometry(*log);
  const auto T_map_scans = slam_of(*log).trajectory();
  const Panel before(scanned_points_m(*log, T_odom_scans), T_odom_scans);
  const Panel after(scanned_points_m(*log, T_map_scans), T_map_scans);
  const int first_column = before.columns() + static_cast<int>(kGutterM / kPictureCellM);
  mapping::RasterMap map(first_column + after.columns(),
                         std::max(before.rows(), after.rows()),
                         kPictureCellM,
                         {0.0, 0.0});
  before.draw(0, map);
  after.draw(first_column, map);
  const exports::MapView view(map,
                              {.legend = {{exports::kGreen, "way"},
                                          {exports::kVermilion, "wall landmarks"},
                                          {exports::kBlue, "point landmarks"}}});
  exports::Picture picture = view.draw();
  before.draw_path(0, view, picture);
  after.draw_path(first_column, view, picture);
  draw_landmarks(slam_of(*log), after, first_column, view, picture);
  std::filesystem::create_directories(edmonton_picture.parent_path());
  picture.write_png(edmonton_picture, view.texts());

  EXPECT_GT(std::filesystem::file_size(edmonton_picture), 10000U);
}

}  // namespace
}  // namespace echomap::papers
