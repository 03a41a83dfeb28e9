// SPDX-License-Identifier: MIT
#include "host/transport/descriptor_stream.hpp"

#include <boost/asio/posix/stream_descriptor.hpp>

#include "host/transport/asio_stream.hpp"

namespace echomap::transport {

std::unique_ptr<ByteStream> descriptor_stream(int fd, const std::string& name) {
  auto stream = std::make_unique<AsioStream<boost::asio::posix::stream_descriptor>>(name);
  stream->stream().assign(fd);
  return stream;
}

}  // namespace echomap::transport
