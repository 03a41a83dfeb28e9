// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <sys/types.h>

#include "host/broker/broker_settings.hpp"
#include "host/broker/certificates.hpp"
#include "host/broker/credentials.hpp"
#include "host/session/child_process.hpp"

namespace echomap::broker {

/// Whether that is an address of no machine in particular, as 0.0.0.0. Throws console::CommandError
/// kConfigInvalid where it is no IP address.
bool is_unspecified(const std::string& address);

/// A Mosquitto broker as a child of this process. Its folder, which only this user can read, has
/// all that it is made of:
///
///     mosquitto.conf, passwords, rights.acl, tls/    what it runs by
///     port                                           where it listens, in decimal digits
///     members/NAME.toml, ca.crt                      credentials of each account, to be copied
///     store/, mosquitto.log                          what it writes
class Broker {
 public:
  /// Writes the folder, starts the broker and waits until it listens. Throws console::CommandError:
  /// kConfigInvalid for settings, kRuntimeError where mosquitto or openssl is missing or fails.
  Broker(const BrokerSettings& settings, const std::filesystem::path& folder);
  /// Ends the broker in order.
  ~Broker();
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;

  std::uint16_t port() const { return port_; }
  const std::filesystem::path& folder() const { return folder_; }
  pid_t pid() const { return process_->pid(); }
  bool is_running() { return process_ && !process_->exit_status(); }
  /// What an account connects with: by the first of BrokerSettings::host_names, or from this
  /// machine where there is none. Throws console::CommandError kRuntimeError where there is no such
  /// account.
  Credentials credentials(const std::string& user) const;
  std::filesystem::path credentials_file(const std::string& user) const;

  /// Ends it by SIGTERM: it writes what is retained. Does nothing where it does not run.
  void stop();
  /// Ends it by SIGKILL: what it has taken since it last wrote is lost.
  void kill();
  /// Starts it again on the same port after stop() or kill().
  void start();
  /// Lets a running broker have other accounts; connections of those that stay stay. Those of
  /// accounts that are gone stay too, with no rights.
  void set_users(std::vector<BrokerUser> users);

 private:
  void write_folder();
  void write_accounts();
  void write_members() const;
  std::filesystem::path log() const { return folder_ / "mosquitto.log"; }
  bool start_on(std::uint16_t port);

  BrokerSettings settings_;
  std::filesystem::path folder_;
  std::filesystem::path program_;
  std::optional<Certificates> certificates_;
  std::uint16_t port_ = 0;
  std::unique_ptr<session::ChildProcess> process_;
};

}  // namespace echomap::broker
