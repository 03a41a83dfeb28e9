// SPDX-License-Identifier: MIT
#include "host/transport/bluetooth_stream.hpp"

#include <algorithm>

#include <bluetooth/bluetooth.h>
#include <bluetooth/rfcomm.h>
#include <boost/asio/generic/stream_protocol.hpp>
#include <sys/socket.h>

#include "host/transport/asio_stream.hpp"
#include "host/transport/bluetooth_address.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {
namespace {

using boost::asio::generic::stream_protocol;
constexpr std::chrono::seconds kBluetoothPatience{10};

/// "00:14:03:05:59:02" of "bt://00:14:03:05:59:02/3".
std::string device_of(const std::string& address) {
  const std::size_t begin = std::min<std::size_t>(address.size(), 5);
  return address.substr(begin, address.find('/', begin) - begin);
}

[[noreturn]] void fail_to_reach_module(const std::string& address, const std::string& why) {
  throw TransportError("cannot connect to " + address,
                       why,
                       "pair the module first: bluetoothctl pair " + device_of(address));
}

stream_protocol::endpoint endpoint_of(const BluetoothAddress& address) {
  sockaddr_rc name{};
  name.rc_family = AF_BLUETOOTH;
  name.rc_channel = address.channel;
  // The kernel keeps the last byte first.
  std::reverse_copy(address.bytes.begin(), address.bytes.end(), name.rc_bdaddr.b);
  return {&name, sizeof name, BTPROTO_RFCOMM};
}

}  // namespace

std::unique_ptr<ByteStream> open_bluetooth_stream(const std::string& address) {
  const auto parsed = parse_bluetooth_address(address);
  if (!parsed) {
    fail_to_reach_module(address, "it is not of the form bt://00:11:22:33:44:55");
  }
  auto stream = std::make_unique<AsioStream<stream_protocol::socket>>(address);
  boost::system::error_code error;
  stream->stream().open(stream_protocol(AF_BLUETOOTH, BTPROTO_RFCOMM), error);
  if (!error) {
    error = connect_within(*stream, kBluetoothPatience, [&](auto handler) {
      stream->stream().async_connect(endpoint_of(*parsed), handler);
    });
  }
  if (error) {
    fail_to_reach_module(address, error.message());
  }
  return stream;
}

}  // namespace echomap::transport
