// SPDX-License-Identifier: MIT
#include "tests/benchmarks/relation_log.hpp"

#include <algorithm>
#include <memory>
#include <variant>

#include "host/datasets/open_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/played_log.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

constexpr double kConeReachM = 4.0;
constexpr double kConeNoiseM = 0.01;
const double beam_width_rad = geometry::radians(15.0);

/// The number of the beam in the middle of the `i`th of `count` even shares.
std::size_t middle_beam(const sensors::RangeScan& scan, std::size_t i, std::size_t count) {
  return (2 * i + 1) * scan.beams.size() / (2 * count);
}

/// What `change` makes of each scan; the other records are as they were.
template <class Change>
RelationLog with_scans(const RelationLog& log, const Change& change) {
  RelationLog changed = log;
  for (datasets::LogRecord& record : changed.records) {
    if (auto* scan = std::get_if<sensors::RangeScan>(&record)) {
      change(*scan);
    }
  }
  return changed;
}

std::optional<double> nearest_within(const sensors::RangeScan& scan, double bearing_rad) {
  std::optional<double> nearest_m;
  for (const sensors::Beam& beam : scan.beams) {
    const double off_rad = std::abs(beam.bearing_rad - bearing_rad);
    if (off_rad <= beam_width_rad / 2.0 && beam.range_m && *beam.range_m < kConeReachM) {
      nearest_m = std::min(*beam.range_m, nearest_m.value_or(kConeReachM));
    }
  }
  return nearest_m;
}

}  // namespace

std::optional<RelationLog> read_relation_log(const std::string& name) {
  const auto folder = tests::real_data("slam_relations");
  if (!std::filesystem::exists(folder)) {
    return std::nullopt;
  }
  RelationLog log;
  const auto reader = datasets::open_log(folder / (name + ".clf.gz"), "carmen");
  while (auto record = reader->next()) {
    log.records.push_back(std::move(*record));
  }
  log.relations = evaluation::read_relations(folder / (name + ".assoc.gz"));
  return log;
}

RelationLog with_beams(const RelationLog& log, std::size_t count) {
  return with_scans(log, [&](sensors::RangeScan& scan) {
    std::vector<sensors::Beam> kept;
    for (std::size_t i = 0; i < count; ++i) {
      kept.push_back(scan.beams[middle_beam(scan, i, count)]);
    }
    scan.beams = std::move(kept);
  });
}

RelationLog with_cones(const RelationLog& log, std::size_t count, std::mt19937& random) {
  std::normal_distribution<double> noise_m(0.0, kConeNoiseM);
  return with_scans(log, [&](sensors::RangeScan& scan) {
    std::vector<sensors::Beam> cones;
    for (std::size_t i = 0; i < count; ++i) {
      const double bearing_rad = scan.beams[middle_beam(scan, i, count)].bearing_rad;
      std::optional<double> range_m = nearest_within(scan, bearing_rad);
      if (range_m) {
        range_m = sensors::returned_range_m(*range_m + noise_m(random), kConeReachM);
      }
      cones.push_back({bearing_rad, range_m});
    }
    scan.beams = std::move(cones);
    scan.beam_width_rad = beam_width_rad;
    scan.max_range_m = kConeReachM;
  });
}

evaluation::RelationError score_odometry(const RelationLog& log) {
  tests::OdometrySink odometry;
  tests::play(log.records, odometry);
  return evaluation::score_relations(odometry.T_odom_robots, log.relations);
}

evaluation::RelationError score_slam(const RelationLog& log, slam::SlamMethod& method) {
  tests::SlamSink slam(method);
  tests::play(log.records, slam, pipeline::PoseSource::kOdometryFromOrigin);
  return evaluation::score_relations(slam.track().trajectory(), log.relations);
}

}  // namespace echomap::bench
