// SPDX-License-Identifier: MIT
#include "host/papers/paper_002_localization.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/papers/comparison.hpp"
#include "host/papers/epuck_field.hpp"
#include "host/papers/epuck_localization.hpp"
#include "host/papers/error_plot.hpp"
#include "host/papers/room_picture.hpp"

namespace echomap::papers {
namespace {

using localization::ObservationModel;
using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;
using paper_report::PaperPicture;

/// Threshold of M / 2.
constexpr double kNeffShare = 0.5;
constexpr double kLightExponent = 0.15;
constexpr double kParticleMarginM = 0.06;

/// Runs of one filter from places all over the path, and their scores.
struct EpuckRuns {
  std::vector<EpuckRun> runs;
  std::vector<EpuckScore> scores;
};

EpuckRuns run_often(const PaperSettings& settings,
                    ObservationModel& model,
                    const EpuckTrial& trial,
                    const std::string& words) {
  EpuckRuns all;
  for (std::size_t i = 0; i < settings.runs; ++i) {
    const double start = static_cast<double>(i + 1) / static_cast<double>(settings.runs + 1);
    const auto seed = settings.seed + static_cast<std::uint32_t>(i);
    all.runs.push_back(localize_epuck(model, trial, start, seed));
    all.scores.push_back(score_of(all.runs.back()));
    settings.progress(words, i + 1, settings.runs);
  }
  return all;
}

Measured percent_where(const EpuckRuns& all, bool (*holds)(const EpuckScore& score)) {
  const auto count = std::ranges::count_if(all.scores, holds);
  return percent(static_cast<std::size_t>(count), all.scores.size());
}

/// Mean over the runs that have converged and, if wanted, are right; nothing where there are none.
std::optional<Measured> mean_where(const EpuckRuns& all,
                                   bool only_right,
                                   double (*number)(const EpuckScore& score)) {
  std::vector<double> numbers;
  for (const EpuckScore& score : all.scores) {
    if (score.converged_at && (score.is_right || !only_right)) {
      numbers.push_back(number(score));
    }
  }
  return numbers.empty() ? std::nullopt : std::optional(paper_report::measured_mean(numbers));
}

/// How many iterations later each run converges with Neff than without; one that never does counts
/// as its last iteration.
Measured later_with_neff(const EpuckRuns& every_step, const EpuckRuns& neff) {
  std::vector<double> later;
  for (std::size_t i = 0; i < neff.scores.size(); ++i) {
    const auto end = static_cast<double>(neff.runs[i].steps.size());
    const auto converged = [&](const EpuckScore& score) {
      return score.converged_at ? static_cast<double>(*score.converged_at) : end;
    };
    later.push_back(converged(neff.scores[i]) - converged(every_step.scores[i]));
  }
  return paper_report::measured_mean(later);
}

/// The three filters, from the same places with the same random numbers.
struct EpuckFilters {
  EpuckRuns every_step;
  EpuckRuns neff;
  EpuckRuns light;
};

EpuckFilters run_filters(const PaperSettings& settings) {
  const auto correlation = correlation_with(map_epuck_field(epuck_field(), {}, settings.seed));
  const auto light = light_from_true_walls();
  return {run_often(settings,
                    *correlation,
                    {.shown_iterations = {1, 21, 76}},
                    "localizing, resampled at every step"),
          run_often(settings,
                    *correlation,
                    {.resampling_share = kNeffShare, .shown_iterations = {80, 201}},
                    "localizing, resampled by Neff"),
          run_often(settings,
                    *light,
                    {.resampling_share = kNeffShare, .likelihood_exponent = kLightExponent},
                    "localizing by the light")};
}

/// A row for resampling at every step and one by Neff, with our model beside the latter.
std::vector<Finding> both_rows(const Finding& finding,
                               const EpuckFilters& filters,
                               const std::function<std::optional<Measured>(const EpuckRuns&)>& of) {
  Finding every_step = finding;
  every_step.quantity += ", resampled at every step";
  every_step.as_told = of(filters.every_step);
  Finding neff = finding;
  neff.quantity += ", by Neff";
  neff.as_told = of(filters.neff);
  neff.ours = of(filters.light);
  return {every_step, neff};
}

std::vector<Finding> localization_findings(const EpuckFilters& filters) {
  std::vector<Finding> findings;
  const auto add = [&](const Finding& finding,
                       const std::function<std::optional<Measured>(const EpuckRuns&)>& of) {
    const auto rows = both_rows(finding, filters, of);
    findings.insert(findings.end(), rows.begin(), rows.end());
  };
  add({.quantity = "right at the end",
       .where = "figures 4 and 6",
       .paper = "shown once",
       .unit = "%"},
      [](const EpuckRuns& all) {
        return percent_where(all, [](const EpuckScore& score) { return score.is_right; });
      });
  add({.quantity = "converged to a wrong place", .paper = "not said", .unit = "%"},
      [](const EpuckRuns& all) {
        return percent_where(
            all, [](const EpuckScore& score) { return score.converged_at && !score.is_right; });
      });
  add({.quantity = "converged at iteration", .where = "section 4.1", .paper = "80; with Neff 201"},
      [](const EpuckRuns& all) {
        return mean_where(all, false, [](const EpuckScore& score) {
          return static_cast<double>(*score.converged_at);
        });
      });
  findings.push_back({.quantity = "iterations that Neff converges later",
                      .where = "section 4.1",
                      .paper = "121, one run each",
                      .as_told = later_with_neff(filters.every_step, filters.neff)});
  add({.quantity = "errors beyond 3 sigma",
       .where = "figure 7",
       .paper = "none",
       .unit = "%",
       .decimals = 1},
      [](const EpuckRuns& all) {
        return mean_where(
            all, true, [](const EpuckScore& score) { return 100.0 * score.beyond_share; });
      });
  add({.quantity = "position is off by",
       .where = "figure 7",
       .paper = "less with Neff, no figure",
       .unit = "mm",
       .decimals = 1},
      [](const EpuckRuns& all) {
        return mean_where(
            all, true, [](const EpuckScore& score) { return 1000.0 * score.mean_error_m; });
      });
  return findings;
}

/// The first run that ends right, or the first where none does.
const EpuckRun& shown_run(const EpuckRuns& all) {
  const auto right = std::ranges::find_if(
      all.scores, [](const EpuckScore& score) { return score.is_right && score.converged_at; });
  return right == all.scores.end() ? all.runs.front()
                                   : all.runs[static_cast<std::size_t>(right - all.scores.begin())];
}

PaperPicture particle_picture(const PaperSettings& settings,
                              const EpuckRun& run,
                              const ShownParticles& shown,
                              const std::string& method,
                              const std::string& where) {
  RoomPicture picture(epuck_field(),
                      {{exports::kGreen, "particles"},
                       {exports::kBlue, "1 standard deviation"},
                       {exports::kVermilion, "the robot"}},
                      kParticleMarginM);
  const ClusterStep& step = run.steps.at(shown.iteration - 1);
  picture.add_points(shown.particles_m, 2.5, exports::kGreen);
  picture.add_ellipse(step.cluster.mean_m, step.cluster.covariance_m2, 1.0, exports::kBlue);
  picture.add_robot(step.T_world_robot, kEpuckRadiusM, exports::kVermilion);
  const std::string iteration = std::to_string(shown.iteration);
  const auto name = "002_" + method + "_" + iteration + ".png";
  return {
      "Iteration " + iteration + (method == "neff" ? ", resampled by Neff" : ""),
      where,
      "All particles and the ellipse of their cluster. Some leave the field: the model compares "
      "local map and grid, and no more.",
      picture.write_png(settings.out / "pictures" / name)};
}

PaperPicture error_picture(const PaperSettings& settings,
                           const EpuckRun& run,
                           const std::string& method,
                           const std::string& title) {
  std::vector<ErrorCurve> curves{{"error in x", {}, {}}, {"error in y", {}, {}}};
  for (const ClusterStep& step : run.steps) {
    const Eigen::Vector2d error_m = step.error_m();
    const Eigen::Vector2d bound_m = 3.0 * step.cluster.stddev_m();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      curves[static_cast<std::size_t>(axis)].error_m.push_back(error_m[axis]);
      curves[static_cast<std::size_t>(axis)].bound_m.push_back(bound_m[axis]);
    }
  }
  return {
      title,
      "figure 7",
      "Error of the particles' mean in x and y, and the bound of three standard deviations; what "
      "is beyond 30 cm is drawn at the edge.",
      draw_errors(settings.out / "pictures" / ("002_errors_" + method + ".png"), curves, 0.3)};
}

std::vector<PaperPicture> localization_pictures(const PaperSettings& settings,
                                                const EpuckFilters& filters) {
  const EpuckRun& every_step = shown_run(filters.every_step);
  const EpuckRun& neff = shown_run(filters.neff);
  std::vector<PaperPicture> pictures;
  for (const ShownParticles& shown : every_step.shown) {
    pictures.push_back(particle_picture(settings, every_step, shown, "every_step", "figure 4"));
  }
  for (const ShownParticles& shown : neff.shown) {
    pictures.push_back(particle_picture(settings, neff, shown, "neff", "figure 6"));
  }
  pictures.push_back(
      error_picture(settings, every_step, "every_step", "Errors, resampled at every step"));
  pictures.push_back(error_picture(settings, neff, "neff", "Errors, resampled by Neff"));
  pictures.push_back(
      error_picture(settings, shown_run(filters.light), "light", "Errors by our model"));
  return pictures;
}

std::vector<paper_report::Equation> localization_equations() {
  return {
      {"Algorithm 4, Monte-Carlo localization",
       "x[m] = sample(u, x[m]);  w[m] = p(z | x[m], map);  draw i with probability ∝ w[i]",
       "host/localization/monte_carlo_localizer.cpp",
       "const PoseBelief& MonteCarloLocalizer::update"},
      {"section 3.3, correlation of local and global map",
       "ρ = Σ (m - m̄)(m_local - m̄) / √(Σ (m - m̄)² Σ (m_local - m̄)²),  p = max(ρ, 0.3)",
       "host/models/map_correlation.cpp",
       "double MapCorrelation::value"},
      {"section 4.1, Neff",
       "Neff = 1 / Σ w²;  resample if Neff < M / 2, else multiply the weights",
       "host/localization/particle_filter.cpp",
       "void ParticleFilter::resample_if_needed"},
      {"section 4.1, low-variance sampler",
       "one random number r in [0, 1/M);  keep the particles at r + k / M of the weights' sum",
       "host/localization/resampling.cpp",
       "void draw_systematic"},
      {"our way, light of an infra-red sensor",
       "σ(r) = near + far · (r / max)³;  a wall at oblique incidence is silent or looks too far",
       "host/models/infrared_range.cpp",
       "double InfraredRange::likelihood"}};
}

}  // namespace

Experiment epuck_localization_experiment(const PaperSettings& settings) {
  const EpuckFilters filters = run_filters(settings);
  Experiment experiment;
  experiment.title = "Monte-Carlo localization, with and without Neff";
  experiment.question =
      "Do 1,000 particles find the e-puck in the grid that it has made, and is it better to "
      "resample only if few of them count?";
  experiment.as_told =
      "1,000 particles anywhere on the free cells of the grid of the second experiment; the "
      "readings make a local map that is correlated with the grid; low-variance resampling at "
      "every step, or where Neff is below 500 (sections 3.3 and 4.1). 400 steps of 3 cm or 30 "
      "degrees beside walls and blocks, each run from another place. A run is right if the mean of "
      "all particles ends within 3 cm of the robot, and has converged from where they stay within "
      "a deviation of 4 cm, wherever that is. Errors are those of right runs since then.";
  experiment.our_way =
      "The same filter by Neff, with a model of each sensor's light in the true walls instead of "
      "the correlation, to the power of 0.15.";
  experiment.answer =
      "In about half of the runs, with and without Neff. The field looks alike in so many places "
      "that the others end at another one, or undecided. Where the robot is found by correlation, "
      "nearly all errors are within three sigma. That it converges later with Neff, as in the "
      "paper's one run of each, is not seen: from one starting place to the next it differs by "
      "more than by Neff. Our model of the light decides sooner and nearly always, and so is more "
      "often certain of a wrong place.";
  experiment.findings = localization_findings(filters);
  experiment.pictures = localization_pictures(settings, filters);
  experiment.equations = localization_equations();
  experiment.open = {
      "What one iteration is, in centimetres or seconds, is not given; nor the noise of motion and "
      "the cells of the local map.",
      "Resampling is said to happen if the \"weight covariance, Neff\" is bigger than M / 2; read "
      "as "
      "smaller, which is what the rule does that the paper cites.",
      "One run of each kind is shown. Figure 7 prints no scale that could be compared.",
      "The correlation is 0 for less agreement than by chance, which would kill all particles by "
      "one bad look: 0.3 here."};
  return experiment;
}

}  // namespace echomap::papers
