// SPDX-License-Identifier: MIT
#include <string>

#include "host/transport/bluetooth_address.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/tcp_address.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using echomap::fuzz::require;
namespace transport = echomap::transport;

void check_tcp(const std::string& name) {
  const auto address = transport::parse_tcp_address(name);
  if (!address) {
    return;
  }
  const int port = std::stoi(address->port);
  require(transport::is_tcp_address(name), "an address has the scheme");
  require(!address->host.empty() && port >= 1 && port <= 65535, "host and port are usable");
  const bool is_number6 = address->host.find(':') != std::string::npos;
  const std::string host = is_number6 ? "[" + address->host + "]" : address->host;
  const auto again = transport::parse_tcp_address("tcp://" + host + ":" + address->port);
  require(again && again->host == address->host && again->port == address->port,
          "an address put together is the same");
}

void check_bluetooth(const std::string& name) {
  if (const auto address = transport::parse_bluetooth_address(name)) {
    require(transport::is_bluetooth_address(name), "an address has the scheme");
    require(address->channel >= 1 && address->channel <= 30, "the channel is one of RFCOMM's");
  }
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {input_of("tcp://127.0.0.1:5000"),
          input_of("tcp://[::1]:65535"),
          input_of("tcp://robot.local:1"),
          input_of("bt://00:14:03:05:59:02"),
          input_of("bt://FF:ff:03:05:59:02/30"),
          input_of("id:75833353"),
          input_of("/dev/ttyACM0")};
}

/// One input is the name of a port.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string name = echomap::fuzz::text_of({data, size});
  check_tcp(name);
  check_bluetooth(name);
  const auto id = transport::port_id_text(name);
  require(!id || "id:" + std::string(*id) == name, "an id is what follows its scheme");
  return 0;
}
