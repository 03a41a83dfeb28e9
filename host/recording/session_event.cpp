// SPDX-License-Identifier: MIT
#include "host/recording/session_event.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace echomap::recording {
namespace {

constexpr std::array<std::pair<SessionEventKind, std::string_view>, 9> kNames{{
    {SessionEventKind::kBeginSession, "begin-session"},
    {SessionEventKind::kLinkReady, "link-ready"},
    {SessionEventKind::kRobotReset, "robot-reset"},
    {SessionEventKind::kBeginScan, "begin-scan"},
    {SessionEventKind::kEndScan, "end-scan"},
    {SessionEventKind::kPoseFix, "pose-fix"},
    {SessionEventKind::kBeginNewMap, "begin-new-map"},
    {SessionEventKind::kJoinMaps, "join-maps"},
    {SessionEventKind::kEndMaps, "end-maps"},
}};

}  // namespace

std::string_view name_of(SessionEventKind kind) {
  return std::find_if(
             kNames.begin(), kNames.end(), [kind](const auto& one) { return one.first == kind; })
      ->second;
}

std::optional<SessionEventKind> event_kind(std::string_view name) {
  const auto* const found = std::find_if(
      kNames.begin(), kNames.end(), [name](const auto& one) { return one.second == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->first);
}

}  // namespace echomap::recording
