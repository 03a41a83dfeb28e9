// SPDX-License-Identifier: MIT
#include "tests/ports/replugs.hpp"

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/transport/port_identity.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/pty_port.hpp"
#include "host/transport/reconnecting_stream.hpp"
#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/sysfs_tree.hpp"

namespace echomap::tests {
namespace {

using transport::PtyPair;
using transport::StreamStatus;

/// A device in one socket, or none there now.
struct SocketedDevice {
  std::string socket;
  std::string tty = "";
  std::optional<PtyPair> pty = std::nullopt;
};

class ReplugBench {
 public:
  ReplugBench() {
    plug(robot_, "ttyUSB0");
    stream_ = std::make_unique<transport::ReconnectingStream>(
        open("/dev/ttyUSB0"), [this, identity = transport::PortIdentity("/dev/ttyUSB0", [this] {
                                       return transport::list_ports(sysfs_.root());
                                     })] { return open(identity.name_now()); });
  }

  bool survives_replug(bool twin_takes_name) {
    const std::string name_before = robot_.tty;
    unplug(robot_);
    while (stream_->status() == StreamStatus::kOpen) {
      stream_->read_some(buffer_, kTurn);
    }
    if (twin_takes_name) {
      plug(twin_, name_before);
    }
    plug(robot_, name_before == "ttyUSB0" ? "ttyUSB1" : "ttyUSB0");
    const bool is_back = reopens() && passes_bytes();
    const bool twin_is_left_alone = !twin_takes_name || twin_.pty->unread_bytes() == 0;
    if (twin_takes_name) {
      unplug(twin_);
    }
    return is_back && twin_is_left_alone;
  }

 private:
  static constexpr std::chrono::milliseconds kTurn{1};
  static constexpr std::chrono::seconds kReplugPatience{5};

  std::unique_ptr<transport::ByteStream> open(const std::string& port) {
    for (const auto* device : {&robot_, &twin_}) {
      if (device->pty && "/dev/" + device->tty == port) {
        return transport::open_pty_port(device->pty->name());
      }
    }
    throw transport::TransportError("cannot open " + port, "it is not there", "plug it in");
  }
  void plug(SocketedDevice& device, const std::string& tty) {
    device.tty = tty;
    device.pty.emplace();
    sysfs_.plug(tty, {device.socket, {0x1a86, 0x7523}, "USB Serial"});
  }
  void unplug(SocketedDevice& device) {
    sysfs_.unplug(device.tty);
    device.pty.reset();
  }
  bool reopens() {
    const auto until = std::chrono::steady_clock::now() + kReplugPatience;
    while (stream_->status() != StreamStatus::kOpen && std::chrono::steady_clock::now() < until) {
      stream_->read_some(buffer_, kTurn);
    }
    return stream_->status() == StreamStatus::kOpen;
  }
  bool passes_bytes() {
    const auto bytes = transport::counting_bytes(16);
    stream_->write(bytes);
    robot_.pty->write(bytes);
    return robot_.pty->read(bytes.size()) == bytes &&
           transport::read_bytes(*stream_, bytes.size()) == bytes;
  }

  ScratchFolder folder_;
  SysfsTree sysfs_{folder_.path()};
  SocketedDevice robot_{"1-1.2"};
  SocketedDevice twin_{"1-1.3"};
  std::unique_ptr<transport::ByteStream> stream_;
  std::array<std::uint8_t, 256> buffer_{};
};

}  // namespace

int measure_survived_replugs(int replugs) {
  ReplugBench bench;
  int survived = 0;
  for (int i = 0; i < replugs; ++i) {
    survived += bench.survives_replug(i % 2 == 0) ? 1 : 0;
  }
  return survived;
}

}  // namespace echomap::tests
