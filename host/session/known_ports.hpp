// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/transport/port_list.hpp"

namespace echomap::session {

/// Where the ports are remembered at which a robot has answered:
/// $XDG_STATE_HOME/echomap/ports.json, by default ~/.local/state/echomap/ports.json. Empty where
/// the user has neither.
std::filesystem::path known_ports_file();

/// The ports at which a robot has answered, by serial number or socket (`is_same_device`). A file
/// that cannot be read is left as it is: then nothing is known, nothing is written, and trouble()
/// says why.
class KnownPorts {
 public:
  explicit KnownPorts(std::filesystem::path file = known_ports_file());

  const std::vector<transport::PortInfo>& ports() const { return ports_; }
  bool has(const transport::PortInfo& port) const;
  /// For people, with the next step; empty where the file is whole, or not there.
  const std::string& trouble() const { return trouble_; }

  /// Writes the file; does nothing for a port that is known under the same name. Throws
  /// files::FileError.
  void remember(const transport::PortInfo& port);
  /// Forgets one. Throws files::FileError.
  void forget(const transport::PortInfo& port);
  /// Forgets all, and moves a file that cannot be read to NAME.unreadable. Throws files::FileError.
  void forget_all();

 private:
  void load();
  void save() const;

  std::filesystem::path file_;
  std::vector<transport::PortInfo> ports_;
  std::string trouble_;
};

}  // namespace echomap::session
