// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::localization {

/// Numbers are ours, chosen on the simulated field of the e-puck: in maps made under a camera the
/// mean is -0.67 to -0.95, in maps bent by odometry alone -0.9 to -1.05.
struct RoundFitParams {
  /// Share of the mean that a new round does not replace: about the last hundred rounds count.
  double kept_share = 0.99;
  double least_log = -0.9;
};

/// How well the rounds of a ring of infra-red sensors agree with the map at the place that a filter
/// believes in: the particles may all be at one place which is only the best of a map that is
/// wrong.
class RoundFit {
 public:
  explicit RoundFit(const RoundFitParams& params = {}) : params_(params) {}

  /// The logarithm of a round's likelihood at the believed place; of rounds in which nothing
  /// answered none is added, for an empty floor agrees with any other.
  void add(double log_likelihood) {
    sum_ = params_.kept_share * sum_ + log_likelihood;
    weight_ = params_.kept_share * weight_ + 1.0;
  }
  /// Forgets what was added, as where the robot may be anywhere.
  void restart() { sum_ = weight_ = 0.0; }
  bool contradicts() const { return weight_ > 0.0 && sum_ / weight_ < params_.least_log; }

 private:
  RoundFitParams params_;
  double sum_ = 0.0;
  double weight_ = 0.0;
};

}  // namespace echomap::localization
