// SPDX-License-Identifier: MIT
#include "host/session/session_player.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"

namespace echomap::session {
namespace {

using recording::SessionEventKind;

/// Hands what a frame says to the feed, if it is an observation.
class FrameHandler {
 public:
  explicit FrameHandler(ObservationFeed& feed) : feed_(feed) {}

  template <class Message>
  void operator()(const Message& message) {
    if constexpr (requires { feed_.take(message); }) {
      feed_.take(message);
    }
  }

 private:
  ObservationFeed& feed_;
};

}  // namespace

SessionPlayer::SessionPlayer(recording::SessionReader& recording,
                             const RobotProfile& profile,
                             const PlayedInto& into)
    : recording_(recording), profile_(profile), into_(into) {}

bool SessionPlayer::play_next() {
  const auto entry = has_ended_ ? std::nullopt : recording_.next();
  if (!entry || recording_.elapsed_s() > end_s_) {
    has_ended_ = true;
    return false;
  }
  has_ended_scan_ = false;
  if (into_.recorder != nullptr) {
    into_.recorder->set_log_time(recording_.time_ns());
  }
  std::visit([this](const auto& one) { play(one); }, *entry);
  return !has_ended_;
}

void SessionPlayer::play(const recording::RecordedFrame& recorded) {
  const recording::LineFrame& frame = recorded.frame;
  if (frame.is_used && !is_left_out()) {
    observe(frame);
  }
  if (into_.recorder == nullptr) {
    return;
  }
  if (recorded.is_sent) {
    into_.recorder->add_sent(frame.data);
  } else {
    into_.recorder->add_received(
        frame.data, frame.is_used ? std::optional(frame.robot_stamp_us) : std::nullopt);
  }
}

void SessionPlayer::observe(const recording::LineFrame& frame) {
  protocol::FrameDecoder decoder(protocol::MessagesToHost::find_schema);
  auto status = protocol::DecodeStatus::kIncomplete;
  for (const std::uint8_t byte : frame.data) {
    status = decoder.take(byte);
  }
  if (status != protocol::DecodeStatus::kFrame || !feed_) {
    throw files::FileError(fmt::format(
        "{}: the robot's frame at {:.3f} s {}",
        recording_.path().string(),
        recording_.elapsed_s(),
        feed_ ? "cannot be read: it is damaged, or of another version of the protocol"
              : "comes before a session has begun\n  next: name the first file of the recording"));
  }
  FrameHandler handler(*feed_);
  protocol::Dispatcher<protocol::MessagesToHost>::dispatch(
      decoder.frame().id, decoder.frame().payload, handler);
  ++observations_;
}

void SessionPlayer::play(const recording::SessionEvent& event) {
  ++observations_;
  switch (event.kind) {
    case SessionEventKind::kBeginScan:
    case SessionEventKind::kEndScan:
    case SessionEventKind::kPoseFix:
      if (!is_left_out()) {
        play_into_maps(event);
      }
      return;
    case SessionEventKind::kEndMaps:
      has_ended_ = true;
      return;
    default:
      if (into_.recorder != nullptr) {
        into_.recorder->add_event(event);
      }
      play_of_session(event);
  }
}

void SessionPlayer::play_into_maps(const recording::SessionEvent& event) {
  if (event.kind == SessionEventKind::kBeginScan) {
    into_.joined.begin_scan();
  } else if (event.kind == SessionEventKind::kEndScan) {
    into_.joined.end_scan();
    has_ended_scan_ = true;
  } else {
    into_.joined.on_pose_fix(
        {time::RobotTime(time::RobotClock::duration(event.value)), event.T_map_robot});
  }
}

void SessionPlayer::play_of_session(const recording::SessionEvent& event) {
  if (event.kind == SessionEventKind::kBeginSession) {
    begin_session();
  } else if (event.kind == SessionEventKind::kLinkReady && feed_) {
    feed_->set_protocol_minor(static_cast<std::uint8_t>(event.value));
  } else if (event.kind == SessionEventKind::kRobotReset && feed_) {
    feed_->restart(time::RobotClock::duration(event.value));
  } else if (event.kind == SessionEventKind::kBeginNewMap && can_change_maps()) {
    into_.atlas->begin_new_map(static_cast<std::size_t>(std::max<std::int64_t>(event.value, 0)));
  } else if (event.kind == SessionEventKind::kJoinMaps && can_change_maps()) {
    into_.atlas->join();
  }
}

void SessionPlayer::begin_session() {
  if (feed_) {
    into_.sessions.begin_next();
  }
  feed_.emplace(profile_, into_.sessions);
}

}  // namespace echomap::session
