// SPDX-License-Identifier: MIT
#include "host/broker/configuration.hpp"

#include <unistd.h>

#include <fmt/format.h>

namespace echomap::broker {
namespace {

/// Topic, packet id and what else a packet has beside its payload.
constexpr std::size_t kPacketOverheadBytes = 1024;

/// No bound but that in bytes. The 0 that stands for no bound makes Mosquitto 2.0.16 to 2.0.20, and
/// Debian's 2.0.11, end the connection of everyone who publishes what it denies.
constexpr int kMaxQueuedMessages = 1'000'000;

std::string listener_lines(const BrokerSettings& settings,
                           std::uint16_t port,
                           const std::optional<Certificates>& certificates) {
  std::string lines = fmt::format("listener {} {}\n", port, settings.address);
  if (certificates) {
    lines += fmt::format("cafile {}\ncertfile {}\nkeyfile {}\ntls_version tlsv1.2\n",
                         certificates->ca.string(),
                         certificates->server.string(),
                         certificates->server_key.string());
  }
  return lines;
}

/// Mosquitto that root starts becomes the user mosquitto, who cannot read what is root's alone.
std::string user_line() { return ::geteuid() == 0 ? "user root\n" : ""; }

}  // namespace

std::string fleet_topics(const std::string& fleet) { return "echomap/1/" + fleet + "/"; }

std::string broker_configuration(const BrokerSettings& settings,
                                 std::uint16_t port,
                                 const std::filesystem::path& folder,
                                 const std::optional<Certificates>& certificates) {
  const auto file = [&](const char* name) { return (folder / name).string(); };
  std::string text = "# Written by echomap at every start of the broker; changes are lost.\n";
  text += listener_lines(settings, port, certificates);
  text += user_line();
  text += fmt::format(
      "allow_anonymous false\n"
      "password_file {}\n"
      "acl_file {}\n"
      "use_username_as_clientid true\n",
      file("passwords"),
      file("rights.acl"));
  text += fmt::format(
      "set_tcp_nodelay true\n"
      "max_inflight_messages 1000\n"
      "max_queued_messages {}\n"
      "max_queued_bytes {}\n"
      "message_size_limit {}\n"
      "max_packet_size {}\n",
      kMaxQueuedMessages,
      settings.max_queued_bytes,
      settings.max_payload_bytes,
      settings.max_payload_bytes + kPacketOverheadBytes);
  text += fmt::format(
      "persistence true\n"
      "persistence_location {}/\n"
      "autosave_interval {}\n"
      "log_dest stderr\n"
      "log_type error\n"
      "log_type warning\n"
      "log_type notice\n",
      file("store"),
      settings.save_interval_s);
  if (settings.bridge) {
    text += bridge_configuration(*settings.bridge, settings.fleet);
  }
  return text;
}

std::string broker_rights(const BrokerSettings& settings) {
  const std::string topics = fleet_topics(settings.fleet);
  std::string text = "# Written by echomap at every start of the broker; changes are lost.\n";
  text += fmt::format("pattern write {}%u/#\n", topics);
  for (const BrokerUser& user : settings.users) {
    const std::string readable = user.name == settings.hub ? "#" : topics + "#";
    text += fmt::format("\nuser {}\ntopic read {}\n", user.name, readable);
    if (user.name == settings.hub) {
      text += "topic read $SYS/#\n";
    }
  }
  return text;
}

std::string bridge_configuration(const SiteBridge& bridge, const std::string& fleet) {
  std::string text = fmt::format(
      "\nconnection {0}\n"
      "address {1}:{2}\n"
      "bridge_protocol_version mqttv50\n"
      "remote_username {0}\n"
      "remote_password {3}\n"
      "remote_clientid {0}\n"
      "cleansession true\n"
      "notifications false\n"
      "bridge_attempt_unsubscribe false\n"
      "restart_timeout 1 30\n",
      bridge.site,
      bridge.host,
      bridge.port,
      bridge.password);
  if (!bridge.ca_file.empty()) {
    text += fmt::format("bridge_cafile {}\n", bridge.ca_file.string());
  }
  for (const char* const kind : {"presence", "manifest/+", "graph/+", "submap/+"}) {
    text += fmt::format("topic +/{} out 1 {} {}{}/\n",
                        kind,
                        fleet_topics(fleet),
                        fleet_topics(bridge.region),
                        bridge.site);
  }
  return text;
}

}  // namespace echomap::broker
