// SPDX-License-Identifier: MIT
#include "host/transport/descriptor_stream.hpp"

#include <boost/asio/posix/stream_descriptor.hpp>

#include "host/transport/asio_stream.hpp"
#include "host/transport/line_speed.hpp"

namespace echomap::transport {
namespace {

using DescriptorStream = AsioStream<boost::asio::posix::stream_descriptor>;

class SerialStream final : public DescriptorStream {
 public:
  using DescriptorStream::DescriptorStream;
  bool set_baud(int baud) override { return set_line_speed(stream().native_handle(), baud); }
};

}  // namespace

std::unique_ptr<ByteStream> descriptor_stream(int fd, const std::string& name) {
  auto stream = std::make_unique<DescriptorStream>(name);
  stream->stream().assign(fd);
  return stream;
}

std::unique_ptr<ByteStream> serial_stream(int fd, const std::string& name) {
  auto stream = std::make_unique<SerialStream>(name);
  stream->stream().assign(fd);
  return stream;
}

}  // namespace echomap::transport
