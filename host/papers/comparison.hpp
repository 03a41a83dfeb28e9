// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/paper_report/paper_report.hpp"
#include "host/papers/explorations.hpp"
#include "host/papers/paper_settings.hpp"

namespace echomap::papers {

/// Runs of the same room and robot by the paper's method and by ours.
struct Comparison {
  std::vector<ExplorationRun> as_told;
  std::vector<ExplorationRun> ours;
};

/// Drives the runs of one method, below `settings.out`/runs/`name`; `words` say what is going on.
/// Throws as `run_explorations`.
std::vector<ExplorationRun> explore(const PaperSettings& settings,
                                    const std::string& name,
                                    const std::string& words,
                                    std::vector<std::string> arguments);

/// A number of summary.json, compared: `pointer` finds it, and `scale` brings it to `unit`.
struct ComparedNumber {
  std::string quantity;
  std::string where;  ///< Place in the paper.
  std::string paper;  ///< The paper's value in words.
  std::string pointer;
  double scale = 1.0;
  std::string unit{};
  int decimals = 1;
};

/// Means over the runs of both methods that have the number.
paper_report::Finding compared(const Comparison& runs, const ComparedNumber& number);

/// Share of runs whose number at `pointer` equals that at `other`, in percent.
paper_report::Measured percent_equal(const std::vector<ExplorationRun>& runs,
                                     const std::string& pointer,
                                     const std::string& other);

/// Whether a pose is right: within 15 cm and 10 degrees.
bool is_right(double error_m, double heading_error_rad);
/// Whether a pose is about right: within 50 cm and 30 degrees.
bool is_about_right(double error_m, double heading_error_rad);

/// Share in percent.
paper_report::Measured percent(std::size_t successes, std::size_t runs);

/// A matrix of a run, points.csv or poses.csv: the first two columns, in metres, moved to the world
/// frame. Throws files::FileError.
std::vector<Eigen::Vector2d> points_of(const ExplorationRun& run,
                                       const std::string& file,
                                       const geometry::Pose2& T_world_map);

/// The map of a run, as the run has drawn it. Throws files::FileError.
paper_report::PaperPicture map_picture(const ExplorationRun& run,
                                       const std::string& title,
                                       const std::string& where,
                                       const std::string& caption);

}  // namespace echomap::papers
