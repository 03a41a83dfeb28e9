// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// The motions of a stop, as round_sweep makes them, handed out one by one.
class ScanPlan {
 public:
  /// Takes the motions of the next stop, one at least, and answers the first of them.
  Motion begin(std::deque<Motion> motions);
  /// The last motion, of this plan or not, has ended so.
  void end_motion(MotionResult result);
  /// Empty once all were handed out.
  std::optional<Motion> next();

  /// Whether a sweep of the last stop was carried out: without any, its sensor is broken.
  bool has_swept() const { return has_swept_; }

 private:
  Motion take();

  std::deque<Motion> motions_;
  bool is_sweeping_ = false;  ///< The last motion was a sweep.
  bool has_swept_ = false;
};

}  // namespace echomap::exploration
