// SPDX-License-Identifier: MIT
#include "host/transport/local_stream.hpp"

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/write.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/host/transport/temporary_folder.hpp"

namespace echomap::transport {
namespace {

using boost::asio::local::stream_protocol;

TEST(LocalStream, ConnectsToASocketByItsPath) {
  const TemporaryFolder folder;
  boost::asio::io_context io;
  stream_protocol::acceptor acceptor(io, stream_protocol::endpoint(folder.file("socket")));
  const auto stream = open_local_stream(folder.file("socket"));
  stream_protocol::socket device = acceptor.accept();
  boost::asio::write(device, boost::asio::buffer(counting_bytes(100)));
  EXPECT_EQ(read_bytes(*stream, 100), counting_bytes(100));
}

TEST(LocalStream, SaysThatNobodyListens) {
  const TemporaryFolder folder;
  try {
    open_local_stream(folder.file("nobody"));
    FAIL() << "it opened";
  } catch (const TransportError& error) {
    EXPECT_EQ(error.why(), "No such file or directory");
    EXPECT_THAT(error.next_step(), testing::HasSubstr("--lockstep " + folder.file("nobody")));
  }
}

TEST(LocalStream, SaysThatAPathIsTooLong) {
  EXPECT_THROW(open_local_stream("/tmp/" + std::string(200, 'x')), TransportError);
}

}  // namespace
}  // namespace echomap::transport
