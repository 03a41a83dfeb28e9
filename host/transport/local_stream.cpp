// SPDX-License-Identifier: MIT
#include "host/transport/local_stream.hpp"

#include <boost/asio/local/stream_protocol.hpp>

#include "host/transport/asio_stream.hpp"
#include "host/transport/transport_error.hpp"

namespace echomap::transport {

using LocalProtocol = boost::asio::local::stream_protocol;

std::unique_ptr<ByteStream> open_local_stream(const std::string& path) {
  auto stream = std::make_unique<AsioStream<LocalProtocol::socket>>(path);
  try {
    stream->stream().connect(LocalProtocol::endpoint(path));
  } catch (const boost::system::system_error& error) {
    throw TransportError("cannot connect to the socket " + path,
                         error.code().message(),
                         "start echomap-mock or echomap-simavr with --lockstep " + path);
  }
  return stream;
}

}  // namespace echomap::transport
