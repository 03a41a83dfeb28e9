// SPDX-License-Identifier: MIT
#include "host/apps/live_source.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "host/exports/run_directory.hpp"
#include "host/localization/pose_gaussian.hpp"

namespace echomap::apps {
namespace {

/// Particles that are shown.
constexpr std::size_t kShownParticles = 1000;

/// A guess: the rest of the floor takes as long as what is there has taken, square metre by square
/// metre.
std::optional<double> left_at_this_pace_s(double elapsed_s, const exploration::Coverage& coverage) {
  return coverage.seen_m2 > 0.0 ? std::optional(elapsed_s * coverage.unseen_m2 / coverage.seen_m2)
                                : std::nullopt;
}

}  // namespace

AtlasSource::AtlasSource(const pipeline::RobotAtlas& atlas,
                         const exploration::Explorer* explorer,
                         std::function<LiveProgress()> progress)
    : atlas_(atlas),
      explorer_(explorer),
      progress_(std::move(progress)),
      maps_changed_before_(atlas.changes()),
      maps_joined_before_(atlas.joins()),
      maps_changed_(atlas.changes()) {}

std::optional<pipeline::PoseEstimate> AtlasSource::pose() const {
  return atlas_.pipeline().pose_estimate();
}

void AtlasSource::publish(double time_s, live_page::RunPublisher& publisher) {
  if (std::exchange(maps_changed_, atlas_.changes()) != atlas_.changes()) {
    publisher.map().begin_new_map(time_s);
  }
  publisher.map().look_at(time_s, atlas_.pipeline().snapshot());
  if (more) {
    more(time_s, publisher);
  }
}

void AtlasSource::describe(live_page::RunState& state) const {
  if (explorer_ != nullptr) {
    state.intent = explorer_->intent();
  }
  const LiveProgress progress = progress_();
  state.stops = progress.stops;
  state.floor_m2 = progress.floor_m2;
  state.travelled_m = progress.travelled_m;
  state.left_s = progress.longest_left_s;
  if (progress.coverage) {
    state.coverage = progress.coverage->share();
    state.unseen_m2 = progress.coverage->unseen_m2;
    state.left_s =
        state.left_s ? state.left_s : left_at_this_pace_s(progress.elapsed_s, *progress.coverage);
  }
}

void AtlasSource::describe(live_page::EventFacts& facts) const {
  facts.maps_changed = atlas_.changes() - maps_changed_before_;
  facts.maps_joined = atlas_.joins() - maps_joined_before_;
}

FilterSource::FilterSource(const tracking::LiveFilter& filter,
                           std::optional<mapping::OccupancyGrid> map,
                           std::function<exploration::Intent()> intent)
    : filter_(filter), map_(std::move(map)), intent_(std::move(intent)) {}

std::optional<pipeline::PoseEstimate> FilterSource::pose() const {
  const auto estimate = filter_.estimate();
  if (!estimate) {
    return std::nullopt;
  }
  const localization::PoseBelief* belief = filter_.hypotheses();
  const bool is_sure =
      belief == nullptr || belief->status == localization::LocalizationStatus::kLocalized;
  return pipeline::PoseEstimate{estimate->T_map_robot,
                                estimate->T_map_robot,
                                is_sure ? std::optional(estimate->covariance) : std::nullopt};
}

void FilterSource::publish(double time_s, live_page::RunPublisher& publisher) {
  if (map_) {
    publisher.map().look_at(time_s, *std::exchange(map_, std::nullopt));
  }
  std::vector<live_page::WeightedPose> particles;
  const std::vector<geometry::Pose2> poses = filter_.sampled_poses(kShownParticles);
  particles.reserve(poses.size());
  for (const geometry::Pose2& T_map_robot : poses) {
    particles.push_back({T_map_robot, 1.0 / static_cast<double>(poses.size())});
  }
  publisher.add_particles(time_s, particles);
}

void FilterSource::describe(live_page::RunState& state) const {
  if (const localization::PoseBelief* belief = filter_.hypotheses()) {
    state.belief = *belief;
  }
  if (intent_) {
    state.intent = intent_();
  }
  state.stops = filter_.trajectory().size();
}

mapping::OccupancyGrid as_grid(const mapping::RasterMap& map) {
  constexpr int kSure = 500;
  mapping::OccupancyGrid grid;
  const Eigen::Vector2d size_m(map.columns() * map.resolution_m(), map.rows() * map.resolution_m());
  const geometry::CellIndex first = grid.cell_at(map.origin_m());
  const geometry::CellIndex last = grid.cell_at(map.origin_m() + size_m);
  for (std::int32_t y = first.y; y <= last.y; ++y) {
    for (std::int32_t x = first.x; x <= last.x; ++x) {
      const auto state = map.state(map.cell_at(grid.center_m({x, y})));
      if (state != mapping::CellState::kUnknown) {
        grid.add({x, y}, state == mapping::CellState::kOccupied ? kSure : -kSure);
      }
    }
  }
  for (const Eigen::Vector2d& center_m : mapping::centers_m(map, mapping::CellState::kOccupied)) {
    grid.add(grid.cell_at(center_m), 2 * kSure);
  }
  return grid;
}

}  // namespace echomap::apps
