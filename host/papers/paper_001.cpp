// SPDX-License-Identifier: MIT
#include "host/papers/paper_001.hpp"

#include <algorithm>

#include "host/geometry/angle.hpp"
#include "host/papers/bounce_drive.hpp"
#include "host/papers/comparison.hpp"
#include "host/papers/contact_localization.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {
namespace {

using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;
using paper_report::PaperPicture;

/// Both ways to follow the walls of one arena.
Comparison trace(const PaperSettings& settings, const std::string& arena) {
  const auto run = [&](const std::string& name, const std::string& words, bool is_told) {
    std::vector<std::string> arguments{"--world=" + arena,
                                       "--robot=create",
                                       "--strategy=coastal",
                                       "--emulator=mock",
                                       "--no-kidnap"};
    if (is_told) {
      arguments.emplace_back("--as-told");
    }
    return explore(settings, "001_" + arena + "_" + name, words + arena, arguments);
  };
  return {run("told", "following the walls as told: ", true),
          run("ours", "following the walls our way: ", false)};
}

/// What the outlines of one arena come to.
std::vector<Finding> findings_of(const Comparison& runs, const std::string& arena) {
  const std::string corners = "/outline_corners";
  const std::string in_the_room = "/room_corners";
  return {{arena + ": runs with as many corners as the room",
           "figure 8",
           "shown once",
           percent_equal(runs.as_told, corners, in_the_room),
           percent_equal(runs.ours, corners, in_the_room),
           "%",
           0},
          compared(runs,
                   {arena + ": corners are off by",
                    "section VI",
                    "\"verified\", no figure",
                    "/corner_rmse_m",
                    100.0,
                    "cm",
                    1}),
          compared(runs, {arena + ": robot time", "", "not given", "/sim_seconds", 1.0, "s", 0})};
}

Experiment outlines(const PaperSettings& settings) {
  const Comparison in_the_l = trace(settings, "create_l");
  const Comparison in_the_t = trace(settings, "create_t");
  Experiment experiment;
  experiment.title = "The outline of a room by its walls";
  experiment.question =
      "Can a robot that only touches walls draw the outline of its room, reflex corners included?";
  experiment.as_told =
      "A Create follows the wall on its right, every 70 ms: at a bump it spins left by 25 degrees, "
      "without a wall at its sensor it turns right, otherwise it drives ahead at 60 mm/s. Bump and "
      "virtual wall together are a non-reflex corner, a long right turn is a reflex one. It ends "
      "when the angle about the start is a full turn (section IV). The outline is made of the "
      "points on the walls, which the paper's path of the robot only runs along.";
  experiment.our_way =
      "The same walk, but the robot keeps a centimetre off the wall, ends where it first touched "
      "it, walks on past the first corner, and spreads the error between both passes evenly over "
      "the path.";
  experiment.answer =
      "Yes. Both rooms have their corners. The angle about the start is a full turn only where all "
      "of the room is seen from the start, and what the odometry is off by stays in the outline; "
      "walking past the first corner again takes it out.";
  experiment.findings = findings_of(in_the_l, "L");
  const auto of_the_t = findings_of(in_the_t, "T");
  experiment.findings.insert(experiment.findings.end(), of_the_t.begin(), of_the_t.end());
  experiment.pictures = {
      map_picture(
          in_the_l.as_told.front(), "The L as told", "figure 8", "Contacts of the first run."),
      map_picture(in_the_l.ours.front(), "The L our way", "figure 8", "Contacts of the first run."),
      map_picture(
          in_the_t.as_told.front(), "The T as told", "figure 8", "Contacts of the first run."),
      map_picture(
          in_the_t.ours.front(), "The T our way", "figure 8", "Contacts of the first run.")};
  experiment.equations = {
      {"equations 4 and 5, correction of a distance",
       "d̃ = a d + b, a and b by least squares over measured drives (the paper has their names "
       "exchanged)",
       "host/localization/odometry_correction.cpp",
       "fit_correction("},
      {"algorithm Follow_wall",
       "bump: spin left; no wall: turn right; otherwise: ahead",
       "host/exploration/coastal.cpp",
       "Roll Coastal::follow_wall"},
      {"corners, figures 4 and 5",
       "bump and virtual wall: non-reflex; right turn past a threshold: reflex",
       "host/exploration/corner_watch.cpp",
       "void CornerWatch::add"}};
  experiment.open = {
      "Sizes of the regions and errors of the outlines are not given; here the rooms are an L and "
      "a T like the two of figure 8.",
      "Equation 4, named a, is the offset, and equation 5, named b, the slope.",
      "An arctan of y / x never reaches a full turn: the angle is summed up here.",
      "Which right turn is long enough for a reflex corner is not said: 45 degrees here."};
  return experiment;
}

std::vector<ContactOutcome> localize_often(const PaperSettings& settings,
                                           const std::string& words,
                                           const ContactTrial& trial) {
  std::vector<ContactOutcome> outcomes;
  for (std::size_t i = 0; i < settings.runs; ++i) {
    outcomes.push_back(localize_by_contacts(trial, settings.seed + static_cast<std::uint32_t>(i)));
    settings.progress(words, i + 1, settings.runs);
  }
  return outcomes;
}

Measured percent_of(const std::vector<ContactOutcome>& outcomes,
                    bool (*holds)(double error_m, double heading_error_rad)) {
  const auto count = std::ranges::count_if(outcomes, [&](const ContactOutcome& outcome) {
    return holds(outcome.error_m, outcome.heading_error_rad);
  });
  return percent(static_cast<std::size_t>(count), outcomes.size());
}

Measured mean_outside(const std::vector<ContactOutcome>& outcomes) {
  std::vector<double> shares;
  for (const ContactOutcome& outcome : outcomes) {
    shares.push_back(outcome.outside_share);
  }
  return scaled(paper_report::measured_mean(shares), 100.0);
}

std::vector<PaperPicture> particle_pictures(const PaperSettings& settings,
                                            const ContactOutcome& told,
                                            const ContactOutcome& ours) {
  const auto draw = [&](const std::string& name,
                        const std::vector<Eigen::Vector2d>& particles_m,
                        const ContactOutcome& outcome) {
    RoomPicture picture(
        contact_room(),
        {{exports::kGreen, "particles"}, {exports::kVermilion, "the robot at the end"}});
    picture.add_points(particles_m, 2.5, exports::kGreen);
    picture.add_robot(outcome.T_world_robot, create_robot().body.radius_m, exports::kVermilion);
    return picture.write_png(settings.out / "pictures" / (name + ".png"));
  };
  return {{"Particles at the start",
           "figure 9b",
           "After the first step, as told.",
           draw("001_first", told.first_particles_m, told)},
          {"Particles at the end, as told",
           "figure 9d",
           "After 25 bumps of the first run.",
           draw("001_told", told.last_particles_m, told)},
          {"Particles at the end, our way",
           "figure 9d",
           "The same drive.",
           draw("001_ours", ours.last_particles_m, ours)}};
}

Experiment localization(const PaperSettings& settings) {
  const auto told = localize_often(settings, "localizing as told", {});
  const auto ours = localize_often(settings,
                                   "localizing our way",
                                   {.particles = 2000,
                                    .alpha_scale = mean_error_scale(),
                                    .likelihood_exponent = 0.3,
                                    .spread = 0.02,
                                    .resampling_share = 0.5});
  Experiment experiment;
  experiment.title = "Localization by contacts";
  experiment.question =
      "Do bumper and virtual wall find the robot in its outline while it bounces about?";
  experiment.as_told =
      "Particles move by equations 9 to 13 with the alphas of section VI, are weighted by bumper "
      "and virtual wall, and resampled at each step; those that have left the outline are "
      "rejected (section V). 1,000 particles, 25 bumps, in a room with one reflex corner.";
  experiment.our_way =
      "The same filter with alphas that mean what the paper says they do, resampling only where "
      "few particles count, a likelihood to the power of 0.3, and some spread of what was "
      "resampled: 2,000 particles.";
  experiment.answer =
      "As told, rarely. Each contact leaves a few particles, and the alphas spread them by less "
      "than the odometry errs, so that few are right in the end, and all may have left the room. "
      "With "
      "some spread, mostly.";
  experiment.findings = {{"localized within 15 cm and 10 degrees",
                          "figure 9",
                          "shown once",
                          percent_of(told, is_right),
                          percent_of(ours, is_right),
                          "%",
                          0},
                         {"within 50 cm and 30 degrees",
                          "figure 9",
                          "\"concentrated at that region\"",
                          percent_of(told, is_about_right),
                          percent_of(ours, is_about_right),
                          "%",
                          0},
                         {"particles outside of the room",
                          "section V-C",
                          "rejected",
                          mean_outside(told),
                          mean_outside(ours),
                          "%",
                          0}};
  experiment.pictures = particle_pictures(settings, told.front(), ours.front());
  experiment.equations = {{"equations 9 to 13, motion",
                           "Φ = φ - sample(α1 d + α2 φ), D = d - sample(α3 d + α4 φ)",
                           "host/models/linear_odometry_motion.hpp",
                           "class LinearOdometryMotion"},
                          {"sample_normal_distribution",
                           "b/6 · Σ₁¹² rand(-1, 1)",
                           "host/models/uniform_sum.hpp",
                           "uniform_sum_sample"},
                          {"section V-C, inside of the outline",
                           "in the polygon of non-reflex corners and in no triangle of reflex ones",
                           "host/geometry/reflex_outline.cpp",
                           "bool ReflexOutline::contains"}};
  experiment.open = {
      "The number of particles and how often they are resampled are not given.",
      "The sampler's standard deviation is b/3; the paper takes b for a variance, and the alphas "
      "for mean errors.",
      "0.8 is both variance and sigma of the virtual wall's error, without a unit: metres of the "
      "distance at which it answers, here."};
  return experiment;
}

Experiment odometry(const PaperSettings& settings) {
  std::vector<double> alpha1_deg;
  std::vector<double> alpha2_deg;
  std::vector<double> alpha3_mm;
  std::vector<double> alpha4_mm;
  for (std::size_t i = 0; i < settings.runs; ++i) {
    const auto alphas = mean_odometry_errors(settings.seed + static_cast<std::uint32_t>(i));
    alpha1_deg.push_back(geometry::degrees(alphas.alpha1_rad_per_m) * 0.36);
    alpha2_deg.push_back(360.0 * alphas.alpha2);
    alpha3_mm.push_back(1000.0 * alphas.alpha3);
    alpha4_mm.push_back(1000.0 * geometry::radians(360.0) * alphas.alpha4_m_per_rad);
  }
  const auto told = [](const std::string& quantity,
                       const std::string& paper,
                       const std::vector<double>& values,
                       const std::string& unit,
                       int decimals) {
    return Finding{quantity,
                   "section VI",
                   paper,
                   paper_report::measured_mean(values),
                   std::nullopt,
                   unit,
                   decimals};
  };
  Experiment experiment;
  experiment.title = "The odometry's mean errors";
  experiment.question = "How large are the alphas of the motion model?";
  experiment.as_told =
      "70 drives of 360 mm and 70 turns by 360 degrees, here of simulated Creates whose wheels, "
      "track and slip vary; the mean absolute error of each (section VI).";
  experiment.answer =
      "Within a factor of two of the paper's for the angles. The simulated wheels are truer than "
      "the "
      "paper's on a drive, and a simulated turn on the spot never moves the robot.";
  experiment.findings = {
      told("turn error of a drive of 360 mm", "0.3 degrees", alpha1_deg, "degrees", 2),
      told("turn error of a turn by 360 degrees", "1 degree", alpha2_deg, "degrees", 2),
      told("drive error of a drive of 1 m", "26 mm", alpha3_mm, "mm", 1),
      told("drive error of a turn by 360 degrees", "0.07 mm", alpha4_mm, "mm", 2)};
  experiment.equations = {{"the alphas",
                           "mean absolute error by drive or turn",
                           "host/papers/contact_localization.cpp",
                           "mean_odometry_errors"}};
  experiment.open = {"Spread of the 70 observations, floor and speed are not given."};
  return experiment;
}

}  // namespace

paper_report::PaperReport paper_001(const PaperSettings& settings) {
  paper_report::PaperReport report;
  report.number = "001";
  report.title = "A Cost Effective Probabilistic Approach to Localization and Mapping";
  report.authors =
      "Dibyendu Mukherjee, Ashirbani Saha, Pankajkumar Mendapara, Dan Wu and Q. M. Jonathan Wu";
  report.summary =
      "An iRobot Create with bumpers, one wall sensor and a virtual wall draws the outline of its "
      "room by following the walls, and is then localized in it by what it runs into.";
  report.experiments = {outlines(settings), odometry(settings), localization(settings)};
  report.seed = settings.seed;
  return report;
}

}  // namespace echomap::papers
