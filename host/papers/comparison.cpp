// SPDX-License-Identifier: MIT
#include "host/papers/comparison.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::papers {
namespace {

std::optional<paper_report::Measured> mean_in(const std::vector<ExplorationRun>& runs,
                                              const ComparedNumber& number) {
  const std::vector<double> numbers = numbers_of(runs, number.pointer);
  return numbers.empty()
             ? std::nullopt
             : std::optional(scaled(paper_report::measured_mean(numbers), number.scale));
}

}  // namespace

std::vector<ExplorationRun> explore(const PaperSettings& settings,
                                    const std::string& name,
                                    const std::string& words,
                                    std::vector<std::string> arguments) {
  const Explorations explorations{name, std::move(arguments), settings.seed, settings.runs};
  return run_explorations(explorations, settings.out / "runs", [&](std::size_t ended) {
    settings.progress(words, ended, settings.runs);
  });
}

paper_report::Finding compared(const Comparison& runs, const ComparedNumber& number) {
  return {number.quantity,
          number.where,
          number.paper,
          mean_in(runs.as_told, number),
          mean_in(runs.ours, number),
          number.unit,
          number.decimals};
}

paper_report::Measured percent_equal(const std::vector<ExplorationRun>& runs,
                                     const std::string& pointer,
                                     const std::string& other) {
  const nlohmann::json::json_pointer one(pointer);
  const nlohmann::json::json_pointer two(other);
  const auto equal = std::ranges::count_if(runs, [&](const ExplorationRun& run) {
    return run.summary.contains(one) && run.summary.contains(two) &&
           run.summary.at(one) == run.summary.at(two);
  });
  return percent(static_cast<std::size_t>(equal), runs.size());
}

bool is_right(double error_m, double heading_error_rad) {
  return error_m < 0.15 && heading_error_rad < geometry::radians(10.0);
}

bool is_about_right(double error_m, double heading_error_rad) {
  return error_m < 0.5 && heading_error_rad < geometry::radians(30.0);
}

paper_report::Measured percent(std::size_t successes, std::size_t runs) {
  return scaled(paper_report::measured_share(successes, runs), 100.0);
}

std::vector<Eigen::Vector2d> points_of(const ExplorationRun& run,
                                       const std::string& file,
                                       const geometry::Pose2& T_world_map) {
  std::istringstream lines(files::read_text_file(run.folder / file));
  std::string line;
  std::getline(lines, line);
  std::vector<Eigen::Vector2d> points_m;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    Eigen::Vector2d point_m;
    char comma = ',';
    if (!(fields >> point_m.x() >> comma >> point_m.y())) {
      throw files::FileError((run.folder / file).string() + ": no point in '" + line + "'");
    }
    points_m.push_back(T_world_map * point_m);
  }
  return points_m;
}

paper_report::PaperPicture map_picture(const ExplorationRun& run,
                                       const std::string& title,
                                       const std::string& where,
                                       const std::string& caption) {
  const std::string bytes = files::read_text_file(run.folder / "map.png");
  return {title, where, caption, {bytes.begin(), bytes.end()}};
}

}  // namespace echomap::papers
