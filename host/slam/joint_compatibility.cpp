// SPDX-License-Identifier: MIT
#include "host/slam/joint_compatibility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace echomap::slam {

namespace {

/// Sightings that are believed together. The covariance of their innovations is kept as its
/// triangular root, to which a further pair adds two rows: the joint distance comes with it.
class JointPairs {
 public:
  explicit JointPairs(const EkfSlamFilter& filter, std::size_t max_pairs)
      : filter_(&filter),
        root_(2 * static_cast<Eigen::Index>(max_pairs), 2 * static_cast<Eigen::Index>(max_pairs)) {}

  void push(const Candidate& candidate) {
    const Eigen::Index size = 2 * static_cast<Eigen::Index>(pairs_.size());
    Eigen::MatrixXd across(size, 2);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      across.middleRows<2>(2 * static_cast<Eigen::Index>(i)) =
          filter_->covariance_between(pairs_[i]->linear, candidate.linear);
    }
    root_.topLeftCorner(size, size).triangularView<Eigen::Lower>().solveInPlace(across);
    const Eigen::Matrix2d own =
        filter_->covariance_between(candidate.linear, candidate.linear) + candidate.linear.noise;
    const Eigen::Matrix2d corner = (own - across.transpose() * across).llt().matrixL();
    root_.block(size, 0, 2, size) = across.transpose();
    root_.block<2, 2>(size, size) = corner;
    Eigen::Vector2d rest = candidate.linear.innovation;
    for (Eigen::Index i = 0; i < size; ++i) {
      rest -= across.row(i).transpose() * whitened_[static_cast<std::size_t>(i)];
    }
    const Eigen::Vector2d white = corner.triangularView<Eigen::Lower>().solve(rest);
    whitened_.push_back(white.x());
    whitened_.push_back(white.y());
    distances_.push_back(distance() + white.squaredNorm());
    pairs_.push_back(&candidate);
  }
  void pop() {
    pairs_.pop_back();
    distances_.pop_back();
    whitened_.resize(whitened_.size() - 2);
  }

  std::size_t size() const { return pairs_.size(); }
  double distance() const { return distances_.empty() ? 0.0 : distances_.back(); }
  bool is_believable() const { return distance() <= chi_square_99(2 * pairs_.size()); }
  bool has(std::size_t landmark) const {
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const Candidate* pair) {
      return pair->landmark == landmark;
    });
  }
  const std::vector<const Candidate*>& pairs() const { return pairs_; }

 private:
  const EkfSlamFilter* filter_;
  Eigen::MatrixXd root_;
  std::vector<const Candidate*> pairs_;
  std::vector<double> whitened_;
  std::vector<double> distances_;
};

/// Candidates of one sighting, the nearest first.
using Choices = std::vector<const Candidate*>;

std::vector<Choices> choices_by_sighting(std::span<const Candidate> candidates) {
  std::vector<Choices> choices;
  for (const Candidate& candidate : candidates) {
    if (choices.empty() || choices.back().front()->sighting != candidate.sighting) {
      choices.emplace_back();
    }
    choices.back().push_back(&candidate);
  }
  for (Choices& of_one : choices) {
    std::stable_sort(of_one.begin(), of_one.end(), [](const auto* left, const auto* right) {
      return left->squared_distance < right->squared_distance;
    });
  }
  // Few choices first: they bound the search.
  std::stable_sort(choices.begin(), choices.end(), [](const Choices& left, const Choices& right) {
    return left.size() < right.size();
  });
  return choices;
}

class BranchAndBound {
 public:
  BranchAndBound(const EkfSlamFilter& filter, std::vector<Choices> choices, std::size_t max_steps)
      : choices_(std::move(choices)), pairs_(filter, choices_.size()), steps_left_(max_steps) {}

  std::vector<Candidate> best() {
    search(0);
    std::vector<Candidate> best;
    best.reserve(best_.size());
    for (const Candidate* pair : best_) {
      best.push_back(*pair);
    }
    return best;
  }

 private:
  void search(std::size_t level) {
    if (level == choices_.size()) {
      if (is_better(pairs_.size())) {
        best_ = pairs_.pairs();
        best_distance_ = pairs_.distance();
      }
      return;
    }
    for (const Candidate* choice : choices_[level]) {
      if (steps_left_ == 0 || !is_better(pairs_.size() + choices_.size() - level)) {
        return;
      }
      if (pairs_.has(choice->landmark)) {
        continue;
      }
      --steps_left_;
      pairs_.push(*choice);
      if (pairs_.is_believable()) {
        search(level + 1);
      }
      pairs_.pop();
    }
    if (is_better(pairs_.size() + choices_.size() - level - 1)) {
      search(level + 1);
    }
  }
  /// Whether a pairing with as many pairs, and at least the distance so far, can still win.
  bool is_better(std::size_t max_pairs) const {
    return max_pairs > best_.size() ||
           (max_pairs == best_.size() && pairs_.distance() < best_distance_);
  }

  std::vector<Choices> choices_;
  JointPairs pairs_;
  std::size_t steps_left_;
  std::vector<const Candidate*> best_;
  double best_distance_ = 0.0;
};

}  // namespace

double chi_square_99(std::size_t degrees) {
  constexpr double kQuantile = 2.3263;
  const auto count = static_cast<double>(degrees);
  const double spread = 2.0 / (9.0 * count);
  return count * std::pow(1.0 - spread + kQuantile * std::sqrt(spread), 3.0);
}

std::vector<Candidate> jointly_compatible(const EkfSlamFilter& filter,
                                          std::span<const Candidate> candidates,
                                          std::size_t max_steps) {
  return BranchAndBound(filter, choices_by_sighting(candidates), max_steps).best();
}

}  // namespace echomap::slam
