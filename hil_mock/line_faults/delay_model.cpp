// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/delay_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echomap::line_faults {
namespace {

std::int64_t next_transfer_us(std::int64_t ready_us,
                              std::int64_t period_us,
                              std::int64_t phase_us) {
  const std::int64_t since_us = ready_us - phase_us;
  const std::int64_t periods = since_us <= 0 ? 0 : (since_us + period_us - 1) / period_us;
  return phase_us + periods * period_us;
}

}  // namespace

DelayParams usb_delays() {
  DelayParams params;
  params.poll_us = 1'000;
  params.host_stall_share = 0.005;
  params.host_stall_us = 50'000;
  return params;
}

DelayParams ftdi_delays() {
  DelayParams params = usb_delays();
  params.poll_us = 16'000;
  return params;
}

DelayParams bluetooth_delays() {
  DelayParams params = usb_delays();
  params.shortest_us = 8'000;
  params.poll_us = 0;
  params.exponential_us = 6'000.0;
  params.stall_share = 0.02;
  params.stall_us = 150'000;
  return params;
}

LineDelays usb_line() { return {usb_delays(), usb_delays()}; }

LineDelays ftdi_line() { return {usb_delays(), ftdi_delays()}; }

LineDelays bluetooth_line() { return {bluetooth_delays(), bluetooth_delays()}; }

LineDelays line_delays(const std::string& name) {
  if (name == "usb") {
    return usb_line();
  }
  if (name == "ftdi") {
    return ftdi_line();
  }
  if (name == "bluetooth") {
    return bluetooth_line();
  }
  throw std::invalid_argument("'" + name + "': expected usb, ftdi or bluetooth");
}

DelayModel::DelayModel(const DelayParams& params, world::NoiseStream noise)
    : params_(params), noise_(noise) {
  poll_phase_us_ = std::llround(noise_.uniform() * static_cast<double>(params_.poll_us));
}

std::int64_t DelayModel::arrival_us(std::int64_t sent_us) {
  std::int64_t at_us = sent_us + draw_delay_us();
  if (params_.poll_beats) {
    at_us = next_transfer_us(at_us, params_.poll_us, poll_phase_us_);
  } else {
    at_us += std::llround(noise_.uniform() * static_cast<double>(params_.poll_us));
  }
  if (noise_.uniform() < params_.host_stall_share) {
    at_us += std::llround(noise_.uniform() * static_cast<double>(params_.host_stall_us));
  }
  last_arrival_us_ = std::max(last_arrival_us_, at_us);
  return last_arrival_us_;
}

std::int64_t DelayModel::draw_delay_us() {
  double delay_us = static_cast<double>(params_.shortest_us);
  if (params_.exponential_us > 0.0) {
    delay_us -= params_.exponential_us * std::log(1.0 - noise_.uniform());
  }
  if (noise_.uniform() < params_.stall_share) {
    delay_us += static_cast<double>(params_.stall_us);
  }
  return std::llround(delay_us);
}

}  // namespace echomap::line_faults
