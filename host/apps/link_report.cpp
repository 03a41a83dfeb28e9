// SPDX-License-Identifier: MIT
#include "host/apps/link_report.hpp"

#include <chrono>

#include <fmt/format.h>

namespace echomap::apps {
namespace {

std::string encoder_errors_text(const exports::LinkSummary& link) {
  if (!link.robot_encoder_errors) {
    return "encoder errors unknown, for the board cannot see them";
  }
  return fmt::format("{} encoder errors ({} left, {} right)",
                     *link.robot_encoder_errors,
                     link.robot_left_encoder_errors.value_or(0),
                     link.robot_right_encoder_errors.value_or(0));
}

}  // namespace

exports::LinkSummary summary_of(const robot_link::LinkStatistics& link, std::uint64_t reconnects) {
  exports::LinkSummary summary;
  summary.frames_received = link.frames_received;
  summary.frames_bad = link.frames_bad;
  summary.frames_lost = link.frames_lost;
  summary.frames_sent = link.frames_sent;
  summary.commands_resent = link.commands_resent;
  summary.credit_released_bytes = link.credit_released_bytes;
  if (link.round_trip) {
    summary.round_trip_us = static_cast<double>(link.round_trip->count());
  }
  summary.resets = link.resets_seen;
  summary.outages = link.outages;
  summary.outage_seconds = std::chrono::duration<double>(link.outage_time).count();
  summary.reconnects = reconnects;
  summary.robot_frames_bad = link.robot_frames_bad;
  summary.robot_frames_lost = link.robot_frames_lost;
  summary.robot_receive_overruns = link.robot_receive_overruns;
  summary.robot_telemetry_dropped = link.robot_telemetry_dropped;
  summary.robot_encoder_errors = link.robot_encoder_errors;
  summary.robot_left_encoder_errors = link.robot_left_encoder_errors;
  summary.robot_right_encoder_errors = link.robot_right_encoder_errors;
  summary.robot_stack_free_bytes = link.robot_stack_free_bytes;
  summary.robot_rate_step = link.robot_rate_step;
  return summary;
}

std::string line_of(const exports::LinkSummary& link) {
  return fmt::format(
      "link: {} frames received, {} bad, {} lost; {} sent, {} bad and {} lost there; {} commands "
      "again, {} resets, {} outages of {:.1f} s, {} reconnects; robot: {}, {} "
      "overruns, {} dropped, {} bytes of stack free, rate step {}",
      link.frames_received,
      link.frames_bad,
      link.frames_lost,
      link.frames_sent,
      link.robot_frames_bad,
      link.robot_frames_lost,
      link.commands_resent,
      link.resets,
      link.outages,
      link.outage_seconds,
      link.reconnects,
      encoder_errors_text(link),
      link.robot_receive_overruns,
      link.robot_telemetry_dropped,
      link.robot_stack_free_bytes ? std::to_string(*link.robot_stack_free_bytes) : "unknown",
      link.robot_rate_step);
}

std::string losses_between(const exports::LinkSummary& before, const exports::LinkSummary& now) {
  std::string text;
  const auto add = [&text](std::uint64_t from, std::uint64_t to, const std::string& what) {
    if (to > from) {
      text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to - from, what);
    }
  };
  add(before.robot_receive_overruns,
      now.robot_receive_overruns,
      "receiver overruns, which lose bytes that we send");
  add(before.robot_telemetry_dropped,
      now.robot_telemetry_dropped,
      "telemetry frames dropped because the line is too slow: raise the baud rate or "
      "odometry_period_ms");
  return text;
}

}  // namespace echomap::apps
