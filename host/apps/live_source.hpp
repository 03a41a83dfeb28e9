// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "host/apps/run_ending.hpp"
#include "host/exploration/explorer.hpp"
#include "host/live_page/event_watch.hpp"
#include "host/live_page/run_publisher.hpp"
#include "host/live_page/run_state.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/session/robot_profile.hpp"
#include "host/tracking/live_filter.hpp"

namespace echomap::apps {

/// Where the live page has from what it shows.
class LiveSource {
 public:
  virtual ~LiveSource() = default;
  /// Where the robot is; empty where nothing says so.
  virtual std::optional<pipeline::PoseEstimate> pose() const = 0;
  /// Publishes what has changed of the map and of what is believed.
  virtual void publish(double time_s, live_page::RunPublisher& publisher) = 0;
  virtual void describe(live_page::RunState& state) const = 0;
  virtual void describe(live_page::EventFacts& /*facts*/) const {}
};

/// How far a run has come.
struct LiveProgress {
  std::size_t stops = 0;
  double floor_m2 = 0.0;
  double travelled_m = 0.0;
  double elapsed_s = 0.0;
  std::optional<double> longest_left_s{};  ///< Where something limits it.
  std::optional<exploration::Coverage> coverage{};
};

/// The maps of a robot that explores, or that a recording is played into.
class AtlasSource final : public LiveSource {
 public:
  /// `explorer` is null where none drives; both outlive this.
  AtlasSource(const pipeline::RobotAtlas& atlas,
              const exploration::Explorer* explorer,
              std::function<LiveProgress()> progress);

  std::optional<pipeline::PoseEstimate> pose() const override;
  void publish(double time_s, live_page::RunPublisher& publisher) override;
  void describe(live_page::RunState& state) const override;
  void describe(live_page::EventFacts& facts) const override;

  /// Publishes what else there is to be shown; null for nothing.
  std::function<void(double time_s, live_page::RunPublisher& publisher)> more = nullptr;

 private:
  const pipeline::RobotAtlas& atlas_;
  const exploration::Explorer* explorer_;
  std::function<LiveProgress()> progress_;
  std::size_t maps_changed_before_;  ///< This, as in a run that is resumed.
  std::size_t maps_joined_before_;
  std::size_t maps_changed_;
};

/// What follows a robot in a map that is given.
class FilterSource final : public LiveSource {
 public:
  /// The filter outlives this. `map` is where the robot is looked for; empty where it is shown
  /// already, or there is none. `intent` tells what who drives is about; null where it cannot.
  FilterSource(const tracking::LiveFilter& filter,
               std::optional<mapping::OccupancyGrid> map,
               std::function<exploration::Intent()> intent = nullptr);

  std::optional<pipeline::PoseEstimate> pose() const override;
  void publish(double time_s, live_page::RunPublisher& publisher) override;
  void describe(live_page::RunState& state) const override;

 private:
  const tracking::LiveFilter& filter_;
  std::optional<mapping::OccupancyGrid> map_;  ///< Until it is published.
  std::function<exploration::Intent()> intent_;
};

/// A map of states as a grid of the pipeline's resolution, without doubt. No occupied cell is lost,
/// however small.
mapping::OccupancyGrid as_grid(const mapping::RasterMap& map);

}  // namespace echomap::apps
