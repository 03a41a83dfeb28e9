// SPDX-License-Identifier: MIT
#include "host/broker/broker.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <set>
#include <thread>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <fmt/format.h>

#include "host/broker/configuration.hpp"
#include "host/broker/program.hpp"
#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::broker {
namespace {

namespace asio = boost::asio;
namespace fs = std::filesystem;
using asio::ip::tcp;

constexpr std::chrono::seconds kStartPatience{10};
/// Writing 100 MB of retained messages takes a second or two.
constexpr std::chrono::seconds kStopPatience{20};
constexpr int kPortAttempts = 5;
constexpr const char* kCaFile = "ca.crt";

[[noreturn]] void fail(const std::string& message) {
  throw console::CommandError(console::ExitCode::kRuntimeError, message);
}

asio::ip::address address_of(const std::string& text) {
  boost::system::error_code error;
  auto address = asio::ip::make_address(text, error);
  if (error) {
    throw console::CommandError(console::ExitCode::kConfigInvalid,
                                "broker: address = '" + text + "' is no IP address");
  }
  return address;
}

/// `port`, or any that is free where it is 0; empty where another program listens there.
std::optional<std::uint16_t> free_port(const std::string& address, std::uint16_t port) {
  asio::io_context io;
  boost::system::error_code error;
  const tcp::endpoint endpoint(address_of(address), port);
  tcp::acceptor acceptor(io);
  acceptor.open(endpoint.protocol());
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  acceptor.bind(endpoint, error);
  if (error && error != asio::error::address_in_use) {
    fail(fmt::format("cannot listen on {}: {}\n  next: name an address of this machine",
                     address,
                     error.message()));
  }
  return error ? std::nullopt : std::optional(acceptor.local_endpoint().port());
}

/// From this machine.
std::string reachable_address(const std::string& address) {
  const auto parsed = address_of(address);
  if (!parsed.is_unspecified()) {
    return address;
  }
  return parsed.is_v4() ? "127.0.0.1" : "::1";
}

bool accepts_connections(const std::string& address, std::uint16_t port) {
  asio::io_context io;
  tcp::socket socket(io);
  boost::system::error_code error;
  socket.connect({address_of(reachable_address(address)), port}, error);
  return !error;
}

std::vector<std::string> certified_hosts(const BrokerSettings& settings) {
  std::vector<std::string> hosts{"localhost"};
  std::set<std::string> known{"localhost"};
  std::vector<std::string> wanted{"127.0.0.1", reachable_address(settings.address)};
  wanted.insert(wanted.end(), settings.host_names.begin(), settings.host_names.end());
  for (const std::string& host : wanted) {
    if (known.insert(host).second) {
      hosts.push_back(host);
    }
  }
  return hosts;
}

/// A file of an account that is gone would bring its password back with the account's name.
void remove_others(const fs::path& members, const std::vector<BrokerUser>& users) {
  for (const auto& entry : fs::directory_iterator(members)) {
    const bool is_known = std::ranges::any_of(
        users, [&](const BrokerUser& user) { return entry.path().stem() == user.name; });
    if (entry.path().extension() == ".toml" && !is_known) {
      fs::remove(entry.path());
    }
  }
}

void make_private_folder(const fs::path& folder) {
  fs::create_directories(folder);
  fs::permissions(folder, fs::perms::owner_all);
}

}  // namespace

bool is_unspecified(const std::string& address) { return address_of(address).is_unspecified(); }

Broker::Broker(const BrokerSettings& settings, const fs::path& folder)
    : settings_(settings), folder_(fs::absolute(folder)) {
  validate(settings_);
  address_of(settings_.address);
  program_ = find_program({"mosquitto", "mosquitto"});
  write_folder();
  for (int attempt = 0; attempt < kPortAttempts; ++attempt) {
    const auto port = free_port(settings_.address, settings_.port);
    if (port && start_on(*port)) {
      return;
    }
    if (settings_.port != 0) {
      break;
    }
  }
  fail(fmt::format("port {} of {} is in use\n  next: end what listens there, or name another port",
                   settings_.port,
                   settings_.address));
}

Broker::~Broker() { stop(); }

Credentials Broker::credentials(const std::string& user) const {
  for (const BrokerUser& each : settings_.users) {
    if (each.name == user) {
      return {settings_.fleet,
              settings_.host_names.empty() ? reachable_address(settings_.address)
                                           : settings_.host_names.front(),
              port_,
              user,
              each.password,
              certificates_ ? certificates_->ca : fs::path()};
    }
  }
  fail("the broker has no user " + user);
}

fs::path Broker::credentials_file(const std::string& user) const {
  return folder_ / "members" / (user + ".toml");
}

void Broker::stop() {
  if (!is_running()) {
    return;
  }
  process_->send(SIGTERM);
  if (!process_->wait_for(kStopPatience)) {
    kill();
  }
}

void Broker::kill() {
  if (is_running()) {
    process_->send(SIGKILL);
    process_->wait_for(kStopPatience);
  }
}

void Broker::start() {
  if (!is_running() && !start_on(port_)) {
    fail(fmt::format("the broker cannot listen on port {} again: another program does", port_));
  }
}

void Broker::set_users(std::vector<BrokerUser> users) {
  settings_.users = std::move(users);
  validate(settings_);
  write_accounts();
  write_members();
  if (is_running()) {
    process_->send(SIGHUP);
  }
}

void Broker::write_folder() {
  make_private_folder(folder_);
  make_private_folder(folder_ / "store");
  if (settings_.tls) {
    certificates_ = make_certificates(folder_ / "tls", settings_.fleet, certified_hosts(settings_));
  }
  write_accounts();
}

void Broker::write_accounts() {
  const fs::path passwords = folder_ / "passwords.new";
  std::string lines;
  for (const BrokerUser& user : settings_.users) {
    lines += user.name + ":" + user.password + "\n";
  }
  files::write_text_file(passwords, lines, files::Readers::kOwner);
  // From a file: words of a command can be seen by every user of the machine.
  if (!settings_.users.empty()) {
    run_program(
        {find_program({"mosquitto_passwd", "mosquitto"}).string(), "-U", passwords.string()},
        "hash the passwords",
        folder_ / "passwd.log");
  }
  fs::rename(passwords, folder_ / "passwords");
  files::write_text_file(folder_ / "rights.acl", broker_rights(settings_), files::Readers::kOwner);
}

/// So that the files can be copied to other machines, the CA is beside them.
void Broker::write_members() const {
  const fs::path members = folder_ / "members";
  make_private_folder(members);
  if (certificates_) {
    fs::copy_file(certificates_->ca, members / kCaFile, fs::copy_options::overwrite_existing);
  }
  remove_others(members, settings_.users);
  for (const BrokerUser& user : settings_.users) {
    Credentials credentials = this->credentials(user.name);
    credentials.ca_file = certificates_ ? kCaFile : "";
    write_credentials(credentials_file(user.name), credentials);
  }
}

/// False where another program listens on the port. Throws where the broker ends by itself.
bool Broker::start_on(std::uint16_t port) {
  files::write_text_file(folder_ / "mosquitto.conf",
                         broker_configuration(settings_, port, folder_, certificates_),
                         files::Readers::kOwner);
  process_ = std::make_unique<session::ChildProcess>(
      std::vector<std::string>{program_.string(), "-c", (folder_ / "mosquitto.conf").string()},
      log());
  const auto end = std::chrono::steady_clock::now() + kStartPatience;
  while (is_running() && !accepts_connections(settings_.address, port)) {
    if (std::chrono::steady_clock::now() > end) {
      fail("mosquitto does not listen: " + last_line_of(log()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (!is_running()) {
    const std::string why = last_line_of(log());
    if (why.find("in use") != std::string::npos) {
      return false;
    }
    fail(fmt::format("mosquitto has ended: {}\n  next: see {}", why, log().string()));
  }
  if (port != port_) {
    port_ = port;
    files::write_text_file(folder_ / "port", std::to_string(port) + "\n");
    write_members();
  }
  return true;
}

}  // namespace echomap::broker
