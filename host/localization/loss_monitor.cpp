// SPDX-License-Identifier: MIT
#include "host/localization/loss_monitor.hpp"

#include <cmath>
#include <stdexcept>

namespace echomap::localization {

namespace {

bool is_share(double value) { return value > 0.0 && value < 1.0; }

}  // namespace

LossMonitor::LossMonitor(const LossMonitorParams& params) : params_(params) {
  if (!is_share(params.slow_share) || !is_share(params.fast_share) ||
      !is_share(params.kidnap_chance) || !(params.suspicious_fall > 0.0)) {
    throw std::invalid_argument(
        "loss monitor: shares and chances are within (0, 1), a fall above 0");
  }
}

bool LossMonitor::is_suspicious(double log_likelihood) {
  if (!slow_) {
    slow_ = log_likelihood;
    fast_ = log_likelihood;
  }
  *slow_ += params_.slow_share * (log_likelihood - *slow_);
  fast_ += params_.fast_share * (log_likelihood - fast_);
  return fast_ < *slow_ - params_.suspicious_fall;
}

void LossMonitor::compare(double log_here, double log_elsewhere) {
  if (log_odds_) {
    *log_odds_ += log_elsewhere - log_here;
  }
}

double LossMonitor::lost_probability() const {
  return log_odds_ ? 1.0 / (1.0 + std::exp(-*log_odds_)) : 0.0;
}

void LossMonitor::suspect() {
  log_odds_ = std::log(params_.kidnap_chance / (1.0 - params_.kidnap_chance));
}

void LossMonitor::clear_suspicion() { log_odds_.reset(); }

void LossMonitor::restart() {
  clear_suspicion();
  slow_.reset();
}

}  // namespace echomap::localization
