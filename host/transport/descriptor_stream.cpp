// SPDX-License-Identifier: MIT
#include "host/transport/descriptor_stream.hpp"

#include <utility>

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

using BeforeClose = std::function<void(int fd)>;

template <class Stream>
std::unique_ptr<ByteStream> stream_over(int fd, const std::string& name, BeforeClose before_close) {
  auto stream = std::make_unique<Stream>(name);
  stream->stream().assign(fd);
  if (before_close) {
    stream->before_close([fd, action = std::move(before_close)] { action(fd); });
  }
  return stream;
}

}  // namespace

std::unique_ptr<ByteStream> descriptor_stream(int fd,
                                              const std::string& name,
                                              std::function<void(int fd)> before_close) {
  return stream_over<DescriptorStream>(fd, name, std::move(before_close));
}

std::unique_ptr<ByteStream> serial_stream(int fd,
                                          const std::string& name,
                                          std::function<void(int fd)> before_close) {
  return stream_over<SerialStream>(fd, name, std::move(before_close));
}

}  // namespace echomap::transport
