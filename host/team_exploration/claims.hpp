// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Whether a claim wins against another one of the same floor. All robots decide alike.
bool beats(const Claim& one, const Claim& other);

/// The view without robots that have been silent for longer than `max_silent_s`, and without the
/// claims of robots that are not in it: what they claimed is free again.
TeamView without_silent(TeamView view, double max_silent_s);

/// The claim of a robot; null where it has none.
const Claim* claim_of(const TeamView& view, const std::string& robot);

/// The robots of a deadlock, each of which waits for the next and the last for the first, which is
/// `robot` and waits for `waits_for`. Empty where a robot of the chain waits for none.
std::vector<std::string> deadlock(const TeamView& view,
                                  const std::string& robot,
                                  const std::string& waits_for);

}  // namespace echomap::team_exploration
