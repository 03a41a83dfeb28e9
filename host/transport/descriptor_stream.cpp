// SPDX-License-Identifier: MIT
#include "host/transport/descriptor_stream.hpp"

#include <utility>

#include <boost/asio/posix/stream_descriptor.hpp>

#include "host/transport/asio_stream.hpp"

namespace echomap::transport {

std::unique_ptr<ByteStream> descriptor_stream(int fd,
                                              const std::string& name,
                                              std::function<void(int fd)> before_close) {
  auto stream = std::make_unique<AsioStream<boost::asio::posix::stream_descriptor>>(name);
  stream->stream().assign(fd);
  if (before_close) {
    stream->before_close([fd, action = std::move(before_close)] { action(fd); });
  }
  return stream;
}

}  // namespace echomap::transport
