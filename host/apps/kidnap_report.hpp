// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/apps/demo_kidnap.hpp"
#include "host/evaluation/trajectory_error.hpp"

namespace echomap::apps {

/// What summary.json says of a robot that was carried off. All errors are those in its own map
/// (evaluation::own_map_error); what is not told is null:
///
/// noticed; found: its last stop told that it is localized, within 15 cm and 10 degrees; stops: how
/// many there were; error_m and heading_error_rad of the last stop where that told so; carried_m:
/// how far it truly was carried; ended: "localized", else "ambiguous" where the last stop told two
/// places or more, else "not localized"; gave_up: why it drove no further before its place was
/// sure, as FinishReason has it, else null; stops_told: of each stop status, lost_probability,
/// error_m and heading_error_rad of its first hypothesis, and places, how many hypotheses have a
/// probability of 0.05 or more.
nlohmann::ordered_json kidnap_report(const DemoKidnap& kidnap,
                                     const std::vector<evaluation::TruePose>& truth);

/// The same for people, in a line.
std::string kidnap_line(const nlohmann::ordered_json& report);

}  // namespace echomap::apps
