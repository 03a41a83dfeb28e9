// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "host/broker/broker_settings.hpp"
#include "host/broker/certificates.hpp"

namespace echomap::broker {

/// Topics of a fleet, of which everyone may write `below/USER/#`.
std::string fleet_topics(const std::string& fleet);

/// mosquitto.conf(5) of a broker whose files are in `folder`. docs/guides/fleet_broker.md says why
/// each line is there.
std::string broker_configuration(const BrokerSettings& settings,
                                 std::uint16_t port,
                                 const std::filesystem::path& folder,
                                 const std::optional<Certificates>& certificates);

/// The file of rights: a user may write below its own name, by `pattern` and user name, because a
/// client id can be forged.
std::string broker_rights(const BrokerSettings& settings);

/// The lines of a bridge upward: retained topics of closed submaps, graph, manifest and presence,
/// put below the site's name in the region.
std::string bridge_configuration(const SiteBridge& bridge, const std::string& fleet);

}  // namespace echomap::broker
