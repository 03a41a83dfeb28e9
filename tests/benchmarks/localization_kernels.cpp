// SPDX-License-Identifier: MIT
#include "tests/benchmarks/localization_kernels.hpp"

#include <functional>
#include <random>
#include <string>

#include "host/geometry/angle.hpp"
#include "host/localization/likelihood_field.hpp"
#include "host/localization/likelihood_field_model.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/localization/motion_update.hpp"
#include "host/localization/pose_hypotheses.hpp"
#include "host/localization/range_update.hpp"
#include "host/localization/resampling.hpp"
#include "tests/benchmarks/localization_workloads.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

using namespace localization;

constexpr std::size_t kParticles = 10'000;
constexpr double kMaxRangeM = 4.0;

Figure nanoseconds(const std::string& name,
                   double units,
                   std::size_t repetitions,
                   const std::function<void()>& work) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i <= repetitions; ++i) {
    const double took_s = processor_seconds(work);
    if (i > 0) {  // The first round warms up.
      seconds.push_back(took_s);
    }
  }
  return {name, 1e9 * tests::median(seconds) / units, "ns", repetitions, {}};
}

Figure field(const mapping::RasterMap& map, int beams, std::size_t repetitions) {
  const LikelihoodField likelihoods(map);
  Particles particles = tracking_cloud(kParticles);
  const auto readings = sweep(beams);
  return nanoseconds("field_" + std::to_string(beams) + "_ns",
                     static_cast<double>(kParticles) * beams,
                     repetitions,
                     [&] {
                       likelihoods.update_weights(readings, 0.1F, {0, kParticles}, particles);
                     });
}

Figure table(const std::string& name,
             const mapping::RasterMap& map,
             double beam_half_angle_rad,
             int beams,
             std::size_t repetitions) {
  RangeTable expected(map, {beam_half_angle_rad, kMaxRangeM});
  const LikelihoodCodes likelihoods(expected, models::BeamModel(models::sonar_cone_returns()));
  const CodedReadings readings(sweep(beams), expected, likelihoods);
  Particles particles = tracking_cloud(kParticles);
  return nanoseconds(name, static_cast<double>(kParticles) * beams, repetitions, [&] {
    fill_under(particles, readings, expected);
    update_weights(expected, readings, 0.1F, {0, kParticles}, particles);
  });
}

Figure motion(std::size_t repetitions) {
  Particles particles = tracking_cloud(kParticles);
  return nanoseconds("motion_ns", kParticles, repetitions, [&] {
    move(particles, {0, kParticles}, {0.1, 0.2, 0.05}, {0.01, 0.02, 0.01, 0.01}, {1, 2});
  });
}

std::vector<float> uneven_weights() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  std::vector<float> weights(kParticles);
  for (float& weight : weights) {
    weight = any(random) * any(random);
  }
  return weights;
}

Figure resample(std::size_t repetitions) {
  const Particles particles = tracking_cloud(kParticles);
  const std::vector<float> weights = uneven_weights();
  std::vector<std::uint32_t> ancestors;
  Particles drawn;
  std::mt19937 random(4);
  return nanoseconds("resample_ns", kParticles, repetitions, [&] {
    draw_ancestors(weights, kParticles, ResamplingScheme::kSystematic, random, ancestors);
    take_ancestors(particles, ancestors, drawn);
  });
}

Figure cluster(std::size_t repetitions) {
  const Particles particles = tracking_cloud(kParticles);
  const std::vector<float> weights = uneven_weights();
  return nanoseconds(
      "cluster_ns", kParticles, repetitions, [&] { find_hypotheses(particles, weights); });
}

Figure full_step(const mapping::RasterMap& map, std::size_t repetitions) {
  const LikelihoodField likelihoods(map);
  FilterStep step(likelihoods, kParticles, 1);
  return nanoseconds("full_step_60_ns", kParticles, repetitions, [&] { step(); });
}

/// The same of the whole localizer: off the floor counts, the sample's size is found, what is drawn
/// is spread, and the belief is judged.
Figure localizer_step(const mapping::RasterMap& map, std::size_t repetitions) {
  LikelihoodFieldModel model(map);
  LocalizerParams params;
  params.filter.min_particles = kParticles;
  params.filter.max_particles = kParticles;
  params.filter.resampling_share = 1.0;
  params.watches_for_loss = false;  // The readings are not those of the place.
  MonteCarloLocalizer localizer(model, params, std::mt19937(4));
  localizer.update({}, {});
  localizer.start_at({7.0, 4.0, 0.5}, 0.2, 0.1);
  const std::vector<RangeReading> readings = sweep(60);
  return nanoseconds(
      "localizer_step_60_ns", kParticles, repetitions, [&] { localizer.update({}, readings); });
}

}  // namespace

std::vector<Figure> localization_kernel_figures(const mapping::RasterMap& map,
                                                std::size_t repetitions) {
  return {field(map, 60, repetitions),
          field(map, 8, repetitions),
          table("cone_8_ns", map, geometry::radians(12.5), 8, repetitions),
          table("beam_60_ns", map, 0.0, 60, repetitions),
          motion(repetitions),
          resample(repetitions),
          cluster(repetitions),
          full_step(map, repetitions),
          localizer_step(map, repetitions)};
}

}  // namespace echomap::bench
