// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace echomap::localization {

/// Settings of a LossMonitor. Values are ours.
struct LossMonitorParams {
  /// How fast the long and the short mean of the readings' likelihood follow (alpha_slow and
  /// alpha_fast of Thrun, Burgard and Fox 2005, table 8.3).
  double slow_share = 0.02;
  double fast_share = 0.7;
  /// Suspicion falls on a robot whose readings have become less likely than that, by the short mean
  /// against the long one, natural logarithm a reading.
  double suspicious_fall = 0.05;
  /// Prior probability that a suspicion is right.
  double kidnap_chance = 0.05;
};

/// Watches whether the readings still come from where a filter has the robot. The two means only
/// raise a suspicion; whether it is right is then judged by Bayes' rule, against a second filter
/// that has looked everywhere since.
class LossMonitor {
 public:
  /// Throws std::invalid_argument for shares and chances that are not within (0, 1).
  explicit LossMonitor(const LossMonitorParams& params = {});

  /// The mean logarithm of a reading's likelihood at the filter's poses; true where it has become
  /// suspicious.
  bool is_suspicious(double log_likelihood);
  /// Weighs a sweep's readings by the filter that is watched, and by the second one.
  void compare(double log_here, double log_elsewhere);
  /// Probability that the second filter is right.
  double lost_probability() const;
  /// Raises a suspicion; its evidence starts from zero.
  void suspect();
  /// Drops the suspicion.
  void clear_suspicion();
  /// Resets everything, also the usual likelihood, after the filter was started elsewhere.
  void restart();

 private:
  LossMonitorParams params_;
  std::optional<double> slow_;
  double fast_ = 0.0;
  std::optional<double> log_odds_;  ///< While there is a suspicion.
};

}  // namespace echomap::localization
