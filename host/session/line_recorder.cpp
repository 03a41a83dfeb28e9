// SPDX-License-Identifier: MIT
#include "host/session/line_recorder.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace echomap::session {
namespace {

/// Ends every frame (docs/protocol.md).
constexpr std::uint8_t kDelimiter = 0;
/// More bytes without a delimiter are no frame, and are recorded as they are.
constexpr std::size_t kMaxRecordedBytes = 256;

/// The bytes up to the first delimiter and with it, or all where there is none.
std::span<const std::uint8_t> first_frame(std::span<const std::uint8_t> bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), kDelimiter);
  return end == bytes.end() ? bytes
                            : bytes.first(static_cast<std::size_t>(end - bytes.begin()) + 1);
}

ros_messages::DiagnosticStatus diagnostics_of(const robot_link::LinkStatistics& link) {
  const std::uint64_t lost = link.frames_lost + link.robot_frames_lost;
  using ros_messages::DiagnosticStatus;
  DiagnosticStatus status{
      DiagnosticStatus::kOk, "link", "frames lost: " + std::to_string(lost), "", {}};
  const auto add = [&status](const char* name, std::uint64_t value) {
    status.values.push_back({name, std::to_string(value)});
  };
  add("frames received", link.frames_received);
  add("frames bad", link.frames_bad);
  add("frames lost", link.frames_lost);
  add("frames sent", link.frames_sent);
  add("commands resent", link.commands_resent);
  add("resets", link.resets_seen);
  add("outages", link.outages);
  add("robot frames bad", link.robot_frames_bad);
  add("robot frames lost", link.robot_frames_lost);
  add("robot receive overruns", link.robot_receive_overruns);
  add("robot telemetry dropped", link.robot_telemetry_dropped);
  if (link.robot_encoder_errors) {
    add("robot encoder errors", *link.robot_encoder_errors);
    add("robot left encoder errors", link.robot_left_encoder_errors.value_or(0));
    add("robot right encoder errors", link.robot_right_encoder_errors.value_or(0));
  }
  add("robot stack free bytes", link.robot_stack_free_bytes.value_or(0));
  return status;
}

}  // namespace

void LineRecorder::set_time(time::HostTime now) {
  if (recorder_ != nullptr) {
    recorder_->set_time(now);
  }
}

void LineRecorder::sent(std::span<const std::uint8_t> bytes) {
  while (recorder_ != nullptr && !bytes.empty()) {
    const auto frame = first_frame(bytes);
    bytes = bytes.subspan(frame.size());
    if (frame.size() > 1) {
      recorder_->add_sent(frame);
    }
  }
}

void LineRecorder::receive(std::span<const std::uint8_t> bytes,
                           const std::function<void(std::span<const std::uint8_t>)>& take) {
  while (!bytes.empty()) {
    const auto piece = first_frame(bytes);
    bytes = bytes.subspan(piece.size());
    used_stamp_us_.reset();
    take(piece);
    received_.insert(received_.end(), piece.begin(), piece.end());
    if (piece.back() != kDelimiter && received_.size() < kMaxRecordedBytes) {
      continue;
    }
    if (recorder_ != nullptr && received_.size() > 1) {
      recorder_->add_received(received_, used_stamp_us_);
    }
    received_.clear();
  }
}

void LineRecorder::record(const recording::SessionEvent& event) {
  if (recorder_ != nullptr) {
    recorder_->add_event(event);
  }
}

void LineRecorder::record(const robot_link::LinkStatistics& link) {
  if (recorder_ != nullptr) {
    recorder_->add_diagnostics(diagnostics_of(link));
  }
}

}  // namespace echomap::session
