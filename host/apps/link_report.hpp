// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "host/exports/summary_json.hpp"
#include "host/robot_link/link_statistics.hpp"

namespace echomap::apps {

/// What summary.json says of the link; its port was opened again `reconnects` times.
exports::LinkSummary summary_of(const robot_link::LinkStatistics& link, std::uint64_t reconnects);

/// The same in a line, for -v.
std::string line_of(const exports::LinkSummary& link);

/// What the robot has lost or miscounted since `before`, and what to look at; empty where nothing.
std::string losses_between(const exports::LinkSummary& before, const exports::LinkSummary& now);

}  // namespace echomap::apps
