// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tests/benchmarks/localization_peers.hpp"

#ifdef ECHOMAP_WITH_MRPT

#include <numbers>

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPosePDFParticles.h>

#include "host/localization/likelihood_field.hpp"
#include "tests/benchmarks/localization_workloads.hpp"
#include "tests/benchmarks/thread_clock.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr std::size_t kParticles = 10'000;

COccupancyGridMap2D grid_of(const mapping::RasterMap& map) {
  COccupancyGridMap2D grid(0.0F,
                           static_cast<float>(map.columns() * map.resolution_m()),
                           0.0F,
                           static_cast<float>(map.rows() * map.resolution_m()),
                           static_cast<float>(map.resolution_m()));
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const mapping::CellState state = map.state({x, y});
      grid.setCell(x,
                   y,
                   state == mapping::CellState::kOccupied ? 0.0F
                   : state == mapping::CellState::kFree   ? 1.0F
                                                          : 0.5F);
    }
  }
  // As our field; each beam counts.
  grid.likelihoodOptions.likelihoodMethod = COccupancyGridMap2D::lmLikelihoodField_Thrun;
  const localization::LikelihoodFieldParams field;
  grid.likelihoodOptions.LF_stdHit = static_cast<float>(field.hit_stddev_m);
  grid.likelihoodOptions.LF_maxCorrsDistance = static_cast<float>(field.max_distance_m);
  grid.likelihoodOptions.LF_decimation = 1;
  return grid;
}

CObservation2DRangeScan scan_of(int beams) {
  const auto readings = sweep(beams);
  CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(2.0 * std::numbers::pi * (beams - 1) / beams);
  scan.rightToLeft = true;
  scan.maxRange = 20.0F;
  scan.resizeScan(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    scan.setScanRange(i, static_cast<float>(*readings[i].range_m));
    scan.setScanRangeValidity(i, true);
  }
  return scan;
}

class Filter {
 public:
  Filter() : particles_(kParticles) {
    const localization::Particles cloud = tracking_cloud(kParticles);
    for (std::size_t i = 0; i < kParticles; ++i) {
      const geometry::Pose2 pose = cloud.pose(i);
      particles_.m_particles[i].d = {pose.x_m(), pose.y_m(), pose.heading_rad()};
    }
    mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
    model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;
    motion_.computeFromOdometry(mrpt::poses::CPose2D(0.0, 0.0, 0.0), model);
    systematic_.resamplingMethod = mrpt::bayes::CParticleFilter::prSystematic;
  }

  void move() {
    motion_.prepareFastDrawSingleSamples();
    mrpt::poses::CPose2D step;
    for (auto& particle : particles_.m_particles) {
      motion_.fastDrawSingleSample(step);
      particle.d = (mrpt::poses::CPose2D(particle.d) + step).asTPose();
    }
  }
  void update_weights(COccupancyGridMap2D& grid, const CObservation2DRangeScan& scan) {
    for (auto& particle : particles_.m_particles) {
      particle.log_w +=
          0.05 * grid.computeObservationLikelihood(scan, mrpt::poses::CPose3D(particle.d));
    }
  }
  void resample() { particles_.performResampling(systematic_); }
  void estimate() {
    particles_.normalizeWeights();
    particles_.getCovarianceAndMean();
  }

 private:
  mrpt::poses::CPosePDFParticles particles_;
  mrpt::obs::CActionRobotMovement2D motion_;
  mrpt::bayes::CParticleFilter::TParticleFilterOptions systematic_;
};

template <typename Work>
double nanoseconds(std::size_t repetitions, double units, const Work& work) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i <= repetitions; ++i) {
    seconds.push_back(processor_seconds(work));
  }
  return 1e9 * tests::median({seconds.begin() + 1, seconds.end()}) / units;
}

}  // namespace

std::map<std::string, double> mrpt_localization_figures(const mapping::RasterMap& map,
                                                        std::size_t repetitions) {
  COccupancyGridMap2D grid = grid_of(map);
  const CObservation2DRangeScan of_60 = scan_of(60);
  const CObservation2DRangeScan of_8 = scan_of(8);
  Filter filter;
  constexpr double kAll = static_cast<double>(kParticles);
  std::map<std::string, double> figures;
  figures["field_60_ns"] =
      nanoseconds(repetitions, 60.0 * kAll, [&] { filter.update_weights(grid, of_60); });
  figures["field_8_ns"] =
      nanoseconds(repetitions, 8.0 * kAll, [&] { filter.update_weights(grid, of_8); });
  figures["motion_ns"] = nanoseconds(repetitions, kAll, [&] { filter.move(); });
  figures["resample_ns"] = nanoseconds(repetitions, kAll, [&] { filter.resample(); });
  Filter other;
  figures["full_step_60_ns"] = nanoseconds(repetitions, kAll, [&] {
    other.move();
    other.update_weights(grid, of_60);
    other.estimate();
    other.resample();
  });
  return figures;
}

}  // namespace echomap::bench

#else

namespace echomap::bench {

std::map<std::string, double> mrpt_localization_figures(const mapping::RasterMap& /*map*/,
                                                        std::size_t /*repetitions*/) {
  fmt::print("mrpt: not installed, skipped; ./run setup --all\n");
  return {};
}

}  // namespace echomap::bench

#endif
