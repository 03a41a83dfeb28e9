// SPDX-License-Identifier: MIT
#include "host/apps/served_page.hpp"

#include <charconv>
#include <random>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "host/console/browser.hpp"
#include "host/console/exit_code.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/files/bundled_files.hpp"

namespace echomap::apps {
namespace {

using std::chrono::steady_clock;

constexpr std::uint16_t kUsualPort = 8360;
constexpr std::chrono::milliseconds kLook(50);

struct ListenAddress {
  std::string address;
  std::optional<std::uint16_t> port;
};

/// Of ADDRESS, ADDRESS:PORT or [IPV6]:PORT.
ListenAddress parse_listen(const std::string& text) {
  const auto colon = text.rfind(':');
  const bool has_port =
      colon != std::string::npos && (text.find(':') == colon || text[colon - 1] == ']');
  std::string address = has_port ? text.substr(0, colon) : text;
  if (address.starts_with('[') && address.ends_with(']')) {
    address = address.substr(1, address.size() - 2);
  }
  if (!has_port) {
    return {address, std::nullopt};
  }
  std::uint16_t port = 0;
  const auto [end, error] =
      std::from_chars(text.data() + colon + 1, text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw console::CommandError(console::ExitCode::kUsage,
                                "--listen " + text +
                                    ": not an ADDRESS or ADDRESS:PORT\n"
                                    "  next: --listen 0.0.0.0:8360, as an example");
  }
  return {address, port};
}

bool is_loopback(const std::string& address) {
  return address.starts_with("127.") || address == "::1" || address == "localhost";
}

/// Of letters and digits; nobody guesses 128 bits.
std::string new_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    token += fmt::format("{:08x}", random());
  }
  return token;
}

}  // namespace

std::unique_ptr<live_page::PageServer> serve_page(const LiveOptions& options,
                                                  std::vector<live_page::ServedRun> runs,
                                                  const std::vector<std::string>& can,
                                                  live_page::PageServer::TakeCommand take_command,
                                                  std::vector<live_page::NamedProtocol> protocols) {
  const ListenAddress listen = parse_listen(options.listen);
  live_page::PageServerParams params;
  params.address = listen.address;
  params.port = listen.port.value_or(kUsualPort);
  params.token = is_loopback(listen.address) ? "" : new_token();
  params.page_folder = files::bundled_folder("host/live_page/built_page");
  params.openapi_file = files::bundled_folder("host/live_page") / "openapi.json";
  params.can = can;
  params.protocols = std::move(protocols);
  std::unique_ptr<live_page::PageServer> server;
  try {
    server = std::make_unique<live_page::PageServer>(params, runs, take_command);
  } catch (const console::CommandError&) {
    if (listen.port) {
      throw;
    }
    params.port = 0;
    server = std::make_unique<live_page::PageServer>(params, runs, take_command);
  }
  console::print("live page: " + server->url());
  if (options.opens_browser && console::has_desktop() && !console::open_in_browser(server->url())) {
    console::print("no browser could be opened: open that address in one");
  }
  return server;
}

void wait_while_watched(const live_page::PageServer& server, std::chrono::milliseconds away) {
  if (server.audience().clients == 0) {
    return;
  }
  console::print("the page stays at " + server.url() + " until it is closed; Ctrl-C ends it, too");
  auto seen = steady_clock::now();
  while (!console::interrupted() && steady_clock::now() - seen < away) {
    std::this_thread::sleep_for(kLook);
    if (server.audience().clients > 0) {
      seen = steady_clock::now();
    }
  }
}

void wait_for_interrupt() {
  while (!console::interrupted()) {
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace echomap::apps
