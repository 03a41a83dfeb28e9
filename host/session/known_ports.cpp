// SPDX-License-Identifier: MIT
#include "host/session/known_ports.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"

namespace echomap::session {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using transport::PortInfo;
using transport::UsbId;

constexpr int kPortsFormat = 1;

/// An absolute path; empty where the variable has none.
fs::path folder_in(const char* variable) {
  const char* const text = std::getenv(variable);
  const fs::path folder = text == nullptr ? "" : text;
  return folder.is_absolute() ? folder : fs::path();
}

std::optional<UsbId> usb_id_in(const std::string& text) {
  unsigned vendor = 0;
  unsigned product = 0;
  if (text.empty()) {
    return std::nullopt;
  }
  if (text.size() != 9 || std::sscanf(text.c_str(), "%4x:%4x", &vendor, &product) != 2) {
    throw std::invalid_argument("'" + text + "' is no USB id like 1a86:7523");
  }
  return UsbId{static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product)};
}

PortInfo port_in(const json& entry) {
  return {entry.at("name"),
          entry.at("description"),
          entry.at("serial_number"),
          usb_id_in(entry.at("usb_id")),
          entry.at("usb_path")};
}

json entry_of(const PortInfo& port) {
  return {{"name", port.name},
          {"description", port.description},
          {"serial_number", port.serial_number},
          {"usb_id", port.usb_id ? to_string(*port.usb_id) : ""},
          {"usb_path", port.usb_path}};
}

std::vector<PortInfo> ports_in(const std::string& text) {
  const json file = json::parse(text);
  if (file.at("format") != kPortsFormat) {
    throw std::invalid_argument("it is of another version of echomap");
  }
  std::vector<PortInfo> ports;
  for (const json& entry : file.at("ports")) {
    ports.push_back(port_in(entry));
  }
  return ports;
}

}  // namespace

fs::path known_ports_file() {
  fs::path state = folder_in("XDG_STATE_HOME");
  if (state.empty()) {
    const fs::path home = folder_in("HOME");
    state = home.empty() ? fs::path() : home / ".local" / "state";
  }
  return state.empty() ? state : state / "echomap" / "ports.json";
}

KnownPorts::KnownPorts(fs::path file) : file_(std::move(file)) { load(); }

void KnownPorts::load() {
  ports_.clear();
  trouble_.clear();
  std::error_code none;
  if (file_.empty() || !fs::exists(file_, none)) {
    return;
  }
  try {
    ports_ = ports_in(files::read_text_file(file_));
  } catch (const std::exception& error) {
    trouble_ = fmt::format(
        "cannot read which ports had a robot, {}: {}\n  next: mend it, or start a new one and keep "
        "the old beside it: echomap ports --forget-all",
        file_.string(),
        error.what());
  }
}

bool KnownPorts::has(const PortInfo& port) const {
  return std::ranges::any_of(ports_,
                             [&](const PortInfo& known) { return is_same_device(known, port); });
}

void KnownPorts::remember(const PortInfo& port) {
  load();  // Another run may have written it since.
  const bool is_there = std::ranges::any_of(ports_, [&](const PortInfo& known) {
    return is_same_device(known, port) && known.name == port.name;
  });
  if (file_.empty() || !trouble_.empty() || is_there) {
    return;
  }
  std::erase_if(ports_, [&](const PortInfo& known) { return is_same_device(known, port); });
  ports_.push_back(port);
  save();
}

void KnownPorts::forget(const PortInfo& port) {
  if (std::erase_if(ports_, [&](const PortInfo& known) { return is_same_device(known, port); }) >
      0) {
    save();
  }
}

void KnownPorts::forget_all() {
  std::error_code error;
  if (!trouble_.empty()) {
    fs::rename(file_, file_.string() + ".unreadable", error);
  } else {
    fs::remove(file_, error);
  }
  if (error) {
    throw files::FileError("cannot remove " + file_.string() + ": " + error.message());
  }
  load();
}

void KnownPorts::save() const {
  json list = json::array();
  for (const PortInfo& port : ports_) {
    list.push_back(entry_of(port));
  }
  std::error_code error;
  fs::create_directories(file_.parent_path(), error);
  if (error) {
    throw files::FileError("cannot create " + file_.parent_path().string() + ": " +
                           error.message());
  }
  files::write_text_file(file_,
                         json{{"format", kPortsFormat}, {"ports", std::move(list)}}.dump(2) + "\n");
}

}  // namespace echomap::session
