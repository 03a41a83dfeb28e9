// SPDX-License-Identifier: MIT
#include "host/papers/paper_004.hpp"

#include <algorithm>

#include "host/papers/comparison.hpp"
#include "host/papers/edmonton.hpp"
#include "host/papers/paper_004_laser.hpp"

namespace echomap::papers {
namespace {

using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;

/// Runs of a fleet take long: so many searches at most, and a single map.
constexpr std::size_t kMaxTeamSearches = 10;

Comparison explore_small_room(const PaperSettings& settings) {
  const auto run = [&](const std::string& slam) {
    return explore(
        settings,
        "004_" + slam,
        "a sonar in a small room, --slam " + slam,
        {"--world=nxt_room", "--emulator=mock", "--no-kidnap", "--stops=8", "--slam=" + slam});
  };
  return {run("none"), run("ekf")};
}

Experiment sonar_room(const PaperSettings& settings) {
  const Comparison runs = explore_small_room(settings);
  const std::string only_announced = "announced, no figure";
  const auto row = [&](const std::string& quantity,
                       const std::string& pointer,
                       double scale,
                       const std::string& unit) {
    return compared(runs,
                    {quantity, "Results and Discussion", only_announced, pointer, scale, unit, 1});
  };
  Experiment experiment;
  experiment.title = "An Arduino and its sonar in a small room";
  experiment.question = "Does EKF-SLAM serve a cheap sonar in a small room, as the paper expects?";
  experiment.as_told =
      "Robots with an Arduino and ultrasonic sensors send what they measure to a computer, which "
      "makes the map of a small room. The paper announces them and gives equations for odometry "
      "alone: here a simulated Arduino Uno with one sonar on a servo explores a room of 5 m² by "
      "its odometry (echomap demo --slam none), from eight stops.";
  experiment.our_way =
      "The same robot with EKF-SLAM: walls and points in the echoes of a metre of the path, and "
      "the odometry's systematic errors, are estimated with the pose (echomap demo --slam ekf).";
  experiment.answer =
      "Yes: on average path and walls are nearer to the truth than by odometry alone.";
  experiment.findings = {row("path is off by (RMS)", "/ate_rmse_m", 100.0, "cm"),
                         row("position at the end is off by", "/final_error_m", 100.0, "cm"),
                         row("walls are off by", "/wall_rmse_m", 100.0, "cm"),
                         row("floor that map and truth share", "/free_iou", 100.0, "%")};
  experiment.pictures = {
      map_picture(runs.as_told.front(), "By odometry", "figure 1b", "The first run."),
      map_picture(runs.ours.front(), "By EKF-SLAM", "figure 2", "The first run.")};
  experiment.equations = {{"walls and points in the echoes of cones",
                           "RANSAC over pairs of echoes, then least squares",
                           "host/slam/sonar_landmarks.cpp",
                           "std::vector<LandmarkSighting> sonar_landmarks"},
                          {"EKF-SLAM over stretches of the path",
                           "sightings, then the motion with the estimated calibration",
                           "host/slam/sonar_landmark_slam.cpp",
                           "void SonarLandmarkSlam::finish_multiscan"}};
  experiment.open = {"Which sonars, how many of them and how they are mounted is not given.",
                     "How landmarks are found in echoes of wide cones is not said.",
                     "The speed that is wanted is \"real time\", without a number."};
  return experiment;
}

std::vector<ExplorationRun> run_command(const PaperSettings& settings,
                                        const std::string& words,
                                        const Explorations& explorations) {
  return run_explorations(explorations, settings.out / "runs", [&](std::size_t ended) {
    settings.progress(words, ended, explorations.runs);
  });
}

Measured percent_found(const std::vector<ExplorationRun>& runs) {
  const auto found = std::ranges::count_if(
      runs, [](const ExplorationRun& run) { return run.summary.at("outcome") == "found"; });
  return percent(static_cast<std::size_t>(found), runs.size());
}

/// Share of searches in which the maps of both robots were one before the end.
Measured percent_joined(const std::vector<ExplorationRun>& runs) {
  const auto joins = numbers_of(runs, "/fleet/joins");
  const auto joined = std::ranges::count_if(joins, [](double count) { return count > 0.0; });
  return percent(static_cast<std::size_t>(joined), runs.size());
}

std::optional<Measured> mean_at(const std::vector<ExplorationRun>& runs,
                                const std::string& pointer,
                                double scale) {
  const auto numbers = numbers_of(runs, pointer);
  return numbers.empty() ? std::nullopt
                         : std::optional(scaled(paper_report::measured_mean(numbers), scale));
}

/// What two robots do together, and one alone.
struct TeamRuns {
  std::vector<ExplorationRun> alone;
  std::vector<ExplorationRun> search;
  std::vector<ExplorationRun> map;
};

TeamRuns run_team(const PaperSettings& settings) {
  const std::vector<std::string> searching{
      "--world=l_room", "--emulator=mock", "--robot=uno_geiger", "--source=2.0,0.6,20"};
  std::vector<std::string> together = searching;
  together.insert(together.end(), {"--robots=2", "--search"});
  const std::vector<std::string> fleet{"fleet", "start"};
  const std::size_t searches = std::min(kMaxTeamSearches, settings.runs);
  return {run_command(settings,
                      "one robot searches a source",
                      {"004_search", searching, settings.seed, settings.runs, {"search"}}),
          run_command(settings,
                      "two robots search a source",
                      {"004_team_search", together, settings.seed, searches, fleet}),
          run_command(settings,
                      "two robots make one map",
                      {"004_team_map",
                       {"--world=l_room", "--emulator=mock", "--robots=2"},
                       settings.seed,
                       1,
                       fleet})};
}

std::vector<Finding> team_findings(const TeamRuns& runs) {
  const auto row = [](const std::string& quantity,
                      const std::string& where,
                      const std::optional<Measured>& ours,
                      const std::string& unit,
                      int decimals) {
    return Finding{quantity, where, "announced, no figure", std::nullopt, ours, unit, decimals};
  };
  const std::string statement = "Problem statement";
  const std::string server = "Results and Discussion, 3";
  return {
      row("one robot has found the source", statement, percent_found(runs.alone), "%", 0),
      row("within, with 95 %",
          statement,
          mean_at(runs.alone, "/source/radius_95_m", 100.0),
          "cm",
          0),
      row("and is off by", statement, mean_at(runs.alone, "/source/truth/error_m", 100.0), "cm", 1),
      row("one robot's time", statement, mean_at(runs.alone, "/sim_seconds", 1.0), "s", 0),
      row("two robots have found it", statement, percent_found(runs.search), "%", 0),
      row("their time", statement, mean_at(runs.search, "/fleet/seconds", 1.0), "s", 0),
      row("their maps were one by then", statement, percent_joined(runs.search), "%", 0),
      row("floor that two robots' map and the truth share",
          server,
          mean_at(runs.map, "/fleet/map/free_iou", 100.0),
          "%",
          0),
      row("walls of that map are off by",
          server,
          mean_at(runs.map, "/fleet/map/wall_rmse_m", 100.0),
          "cm",
          1),
      row("the two maps have become one after",
          server,
          mean_at(runs.map, "/fleet/course/joined_s", 1.0),
          "s",
          0)};
}

Experiment team(const PaperSettings& settings) {
  const TeamRuns runs = run_team(settings);
  Experiment experiment;
  experiment.title = "Robots that share a map and search a source";
  experiment.question = "Do two robots that share what they observe find a source, and one map?";
  experiment.as_told =
      "Robots search sources of radiation and share what they observe, by radio, over one server "
      "that has the overall map. The paper states this problem and gives no method for it.";
  experiment.our_way =
      "echomap search with one robot that has a Geiger tube, and echomap fleet start --search with "
      "two, in an L-shaped room with one source; then echomap fleet start with two that map it. "
      "Maps are joined by their surfaces, not in one EKF; readings of both count once their maps "
      "are joined. A fleet's messages arrive as the computer's load lets them, so that its runs "
      "repeat about, not exactly.";
  experiment.answer =
      "Yes, but in a room this small not by sharing: a search mostly ends before the two robots' "
      "maps are one, so that each has only its own readings, and two are sooner because they look "
      "from two places. Two robots that go on mapping have one map after some minutes.";
  experiment.findings = team_findings(runs);
  ExplorationRun joint = runs.map.front();
  joint.folder /= "team";
  experiment.pictures = {
      map_picture(runs.alone.front(), "One robot's search", "", "The first run."),
      map_picture(
          joint, "The map of two robots", "", "The first run. Lines lead from stop to stop.")};
  experiment.equations = {{"source search, ours",
                           "P(hypothesis) *= Poisson(counts; rate at the place)",
                           "host/source_search/source_belief.cpp",
                           "void SourceBelief::add("},
                          {"maps of several robots, ours",
                           "relative poses by matched surfaces, then one pose graph",
                           "host/team_map/team_map.cpp",
                           "void TeamMap::join_pairs"}};
  experiment.open = {"Neither what robots send nor how maps or places become one is given.",
                     "How a source is sensed, and when a search ends, is not said.",
                     "Search without long-distance communication, and of several sources, is named "
                     "and not treated; echomap search looks for one."};
  return experiment;
}

}  // namespace

paper_report::PaperReport paper_004(const PaperSettings& settings) {
  paper_report::PaperReport report;
  report.number = "004";
  report.title = "Robot Localization and Map Construction Using Sensor Data";
  report.authors = "A. Zh. Akzhalova and Y. V. Polichshuk";
  report.summary =
      "EKF-SLAM on the log of a robot with a laser, and a plan: cheap robots with sonars that "
      "share a map over a server and search sources of radiation.";
  report.experiments = {edmonton_experiment(settings, public_logs()),
                        hall_experiment(settings),
                        sonar_room(settings),
                        team(settings)};
  report.seed = settings.seed;
  return report;
}

}  // namespace echomap::papers
