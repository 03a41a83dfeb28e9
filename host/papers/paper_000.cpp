// SPDX-License-Identifier: MIT
#include "host/papers/paper_000.hpp"

#include <algorithm>

#include "host/geometry/angle.hpp"
#include "host/papers/comparison.hpp"
#include "host/papers/nxt_room.hpp"
#include "host/papers/room_floor.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {
namespace {

using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;
using paper_report::PaperPicture;

/// A sure claim: a standard deviation of the position below this.
constexpr double kSureM = 0.05;
constexpr double kNxtRadiusM = 0.1;
/// The filter is tried from so many places for each run of the robot.
constexpr std::size_t kStartsPerRun = 3;

Comparison explore_both(const PaperSettings& settings) {
  const std::vector<std::string> robot{"--world=nxt_room", "--robot=nxt_tribot", "--emulator=mock"};
  std::vector<std::string> as_told = robot;
  as_told.insert(as_told.end(),
                 {"--strategy=nxt-farthest", "--as-told", "--slam=none", "--no-kidnap"});
  std::vector<std::string> ours = robot;
  ours.emplace_back("--strategy=frontier");
  return {explore(settings, "000_farthest", "exploring as told", as_told),
          explore(settings, "000_frontier", "exploring our way", ours)};
}

Finding compared_picture(const Comparison& runs,
                         const std::string& quantity,
                         const std::string& pointer,
                         double scale,
                         const std::string& unit) {
  return compared(runs, {quantity, "figure 8", "a picture, no figure", pointer, scale, unit, 1});
}

/// The map of section 3.1, a cloud of echoes, and where they were measured.
PaperPicture cloud_picture(const PaperSettings& settings, const ExplorationRun& run) {
  const world::FloorPlan room = bundled_room("nxt_room");
  const geometry::Pose2& T_world_map = room.T_world_start();
  RoomPicture picture(room, {{exports::kBlue, "echoes"}, {exports::kPurple, "stops"}});
  picture.add_points(points_of(run, "points.csv", T_world_map), 2.5, exports::kBlue);
  picture.add_points(points_of(run, "poses.csv", T_world_map), 5.0, exports::kPurple);
  return {"The map as told",
          "figure 8",
          "The echoes of the first run, placed by odometry alone, on the true walls.",
          picture.write_png(settings.out / "pictures" / "000_cloud.png")};
}

Experiment exploration(const PaperSettings& settings, const Comparison& runs) {
  Experiment experiment;
  experiment.title = "Mapping a room by the farthest echoes";
  experiment.question =
      "Does a robot with one sonar on a motor map a room, if it knows nothing but its last sweep?";
  experiment.as_told =
      "120 readings in two turns, every 6 degrees; then a turn towards one of the four farthest "
      "echoes, chosen at random, and half of the distance to it (section 3.2). Poses are odometry "
      "alone, and the map is the cloud of all echoes. The paper does not say when it ends: here, "
      "when two stops in a row have shown no new floor.";
  experiment.our_way =
      "The same robot in the same room with our frontier exploration: it drives where a look shows "
      "most floor for its time, aligns its walls by graph SLAM, and ends when nothing is unseen.";
  experiment.answer =
      "Yes, roughly. The cloud shows the room, as the paper's picture does. But odometry bends it, "
      "and by chance a part of the walls is never looked at from near.";
  experiment.findings = {
      compared_picture(runs, "walls that the map has", "/wall_recall", 100.0, "%"),
      compared_picture(runs, "walls are off by", "/wall_rmse_m", 100.0, "cm"),
      compared_picture(runs, "free floor that agrees", "/free_iou", 100.0, "%"),
      compared_picture(runs, "pose is off by", "/ate_rmse_m", 100.0, "cm"),
      compared_picture(runs, "stops", "/stops", 1.0, ""),
      compared_picture(runs, "robot time", "/sim_seconds", 1.0, "s")};
  experiment.pictures = {cloud_picture(settings, runs.as_told.front()),
                         map_picture(runs.ours.front(),
                                     "The map our way",
                                     "figure 8",
                                     "The same robot with frontier exploration and graph SLAM.")};
  experiment.equations = {{"section 3.2, one of the four farthest",
                           "next = here + ½ · r, r drawn from the four largest of 120 readings",
                           "host/exploration/nxt_farthest.cpp",
                           "Motion NxtFarthest::next"},
                          {"our utility of a viewpoint",
                           "utility = new floor in view / (time to drive there + time to look)",
                           "host/exploration/frontier.cpp",
                           "Motion Frontier::next"}};
  experiment.open = {
      "No dimension of the room, no error and no total time is given; here the room is 2.8 x 2.2 "
      "m, as large as a sonar of 2.3 m can survey.",
      "When the exploration ends is not said.",
      "Ghost echoes stay in the paper's map; ours has a model of the cone."};
  return experiment;
}

/// Whether the pose or its twin is as near as that.
bool is_found(const NxtOutcome& outcome, bool (*holds)(double error_m, double heading_error_rad)) {
  return holds(outcome.error_m, outcome.heading_error_rad) ||
         holds(outcome.twin_error_m, outcome.twin_heading_error_rad);
}

/// The particle filter of section 4 from many places, by one set of settings.
std::vector<NxtOutcome> localize_often(const PaperSettings& settings,
                                       const world::FloorPlan& room,
                                       const std::vector<Eigen::Vector2d>& cloud_m,
                                       const NxtTrial& trial) {
  std::vector<NxtOutcome> outcomes;
  for (std::size_t i = 0; i < kStartsPerRun * settings.runs; ++i) {
    const auto seed = settings.seed + static_cast<std::uint32_t>(i);
    outcomes.push_back(localize_nxt(room, cloud_m, trial, seed));
    settings.progress("localizing as told", i + 1, kStartsPerRun * settings.runs);
  }
  return outcomes;
}

template <class Condition>
Measured percent_of(const std::vector<NxtOutcome>& outcomes, Condition&& holds) {
  const auto count = std::count_if(outcomes.begin(), outcomes.end(), holds);
  return percent(static_cast<std::size_t>(count), outcomes.size());
}

/// Of our runs, those that end localized within these errors, and the others.
struct Kidnaps {
  std::size_t right = 0;
  std::size_t wrong = 0;  ///< Claims to be localized, and is not within the errors.
  std::size_t runs = 0;
};

Kidnaps kidnaps_of(const std::vector<ExplorationRun>& runs) {
  Kidnaps kidnaps;
  for (const ExplorationRun& run : runs) {
    if (!run.summary.contains("kidnap")) {
      continue;
    }
    const auto& kidnap = run.summary.at("kidnap");
    ++kidnaps.runs;
    if (kidnap.at("found").get<bool>()) {
      const bool is_there = is_right(kidnap.at("error_m").get<double>(),
                                     kidnap.at("heading_error_rad").get<double>());
      ++(is_there ? kidnaps.right : kidnaps.wrong);
    }
  }
  return kidnaps;
}

std::vector<PaperPicture> particle_pictures(const PaperSettings& settings,
                                            const world::FloorPlan& room,
                                            const std::vector<Eigen::Vector2d>& cloud_m,
                                            const NxtOutcome& outcome) {
  const auto draw = [&](const std::string& name, const std::vector<Eigen::Vector2d>& particles_m) {
    RoomPicture picture(room,
                        {{exports::kBlue, "echoes of the map"},
                         {exports::kGreen, "particles"},
                         {exports::kVermilion, "the robot"}});
    picture.add_points(cloud_m, 2.0, exports::kBlue);
    picture.add_points(particles_m, 5.0, exports::kGreen);
    picture.add_robot(outcome.T_world_robot, kNxtRadiusM, exports::kVermilion);
    return picture.write_png(settings.out / "pictures" / (name + ".png"));
  };
  return {{"Particles after the first eight readings",
           "figure 10",
           "Before the robot has moved. It is drawn where it stands at the end.",
           draw("000_first", outcome.first_particles_m)},
          {"Particles at the end",
           "figure 11",
           "After ten rounds. All lie within a millimetre or so, right or wrong; the empty room "
           "looks the same after half a turn.",
           draw("000_last", outcome.last_particles_m)}};
}

std::vector<Finding> kidnap_findings(const std::vector<NxtOutcome>& told,
                                     const std::vector<NxtOutcome>& printed,
                                     const Kidnaps& kidnaps) {
  const auto is_near = [](const NxtOutcome& outcome) { return is_found(outcome, is_right); };
  const auto is_about = [](const NxtOutcome& outcome) { return is_found(outcome, is_about_right); };
  const auto is_sure_and_wrong = [&](const NxtOutcome& outcome) {
    return outcome.stddev_m < kSureM && !is_near(outcome);
  };

  const auto finding = [](const std::string& quantity,
                          const std::string& where,
                          const std::string& paper,
                          const Measured& as_told,
                          const std::optional<Measured>& our) {
    return Finding{quantity, where, paper, as_told, our, "%", 0};
  };
  return {finding("localized within 15 cm and 10 degrees",
                  "figure 11",
                  "shown once",
                  percent_of(told, is_near),
                  percent(kidnaps.right, kidnaps.runs)),
          finding("within 50 cm and 30 degrees",
                  "section 4.5: \"approximate location\"",
                  "shown once",
                  percent_of(told, is_about),
                  std::nullopt),
          finding("sure and wrong",
                  "",
                  "not judged",
                  percent_of(told, is_sure_and_wrong),
                  percent(kidnaps.wrong, kidnaps.runs)),
          finding("right, resampled after each reading as printed",
                  "Algorithm 1, line 33",
                  "no figure given",
                  percent_of(printed, is_near),
                  std::nullopt)};
}

Experiment localization(const PaperSettings& settings, const std::vector<ExplorationRun>& ours) {
  const auto room = bundled_room("empty_room");
  const auto cloud_m = nxt_cloud(room, settings.seed);
  const auto told = localize_often(settings, room, cloud_m, {});
  const auto printed =
      localize_often(settings, room, cloud_m, {.resamples_after_each_reading = true});
  Experiment experiment;
  experiment.title = "The kidnapped robot";
  experiment.question = "Do 250 particles find the robot in its map, by eight readings a round?";
  experiment.as_told =
      "250 particles over the room; ten rounds of eight readings 45 degrees apart, a turn by 20 "
      "degrees and 6 cm. Noise of 3 cm for a reading, 0.25 degrees for a turn and 0.5 mm for a "
      "drive; the resampling wheel after each round (sections 4.3 to 4.5). The map is the cloud of "
      "600 readings from five true places of an empty room of 2.5 x 2 m. A pose is right within 15 "
      "cm and 10 degrees, or where it would be right after half a turn of the room, which cannot "
      "be told apart.";
  experiment.our_way =
      "The same robot is carried off in the room of the first experiment, which is unlike itself "
      "after half a turn, and localized in the map that it has made of it, by whole sweeps; it "
      "says "
      "when it is sure. Runs whose map is unfinished are not carried off, and do not count.";
  experiment.answer =
      "About, and it does not know how well. The product of eight narrow densities leaves one "
      "particle, and noise of half a millimetre never spreads its copies again: whatever it is off "
      "by, it claims a millimetre.";
  experiment.findings = kidnap_findings(told, printed, kidnaps_of(ours));
  experiment.pictures = particle_pictures(settings, room, cloud_m, told.front());
  experiment.equations = {{"equation 1, likelihood of a reading",
                           "p = Π exp(-(μ - x)² / 2σ²) / √(2πσ²)",
                           "host/models/gaussian_range.hpp",
                           "class GaussianRange"},
                          {"Algorithm 1, particle filter",
                           "weight by equation 1, resample, move by 20° and 6 cm with noise",
                           "host/papers/nxt_room.cpp",
                           "NxtOutcome localize_nxt"},
                          {"Algorithm 2, resampling wheel",
                           "β += U(0, 2 max w); while w[i] < β: β -= w[i], i += 1; keep i",
                           "host/localization/resampling.cpp",
                           "void draw_by_wheel"}};
  experiment.open = {
      "The algorithm compares an angle with that of each map point by equality of rounded values; "
      "here the nearest point counts that is within 3 cm or 3 degrees of the beam.",
      "N stands for the number of particles and of map points, and resampling stands inside of the "
      "loop over readings: read as after it.",
      "No repetition, no error: whether the cluster is where the robot is was judged by eye."};
  return experiment;
}

}  // namespace

paper_report::PaperReport paper_000(const PaperSettings& settings) {
  const Comparison runs = explore_both(settings);
  paper_report::PaperReport report;
  report.number = "000";
  report.title = "Map Construction and Localization Using LEGO Mindstorms NXT";
  report.authors = "Jasmeet Singh and Punam Bedi, 2013";
  report.summary =
      "A LEGO robot with one sonar on a motor maps an empty room by the farthest echoes, and "
      "finds itself again in that map with 250 particles.";
  report.experiments = {exploration(settings, runs), localization(settings, runs.ours)};
  report.seed = settings.seed;
  return report;
}

}  // namespace echomap::papers
