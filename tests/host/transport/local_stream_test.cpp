// SPDX-License-Identifier: MIT
#include "host/transport/local_stream.hpp"

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/write.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

using boost::asio::local::stream_protocol;

TEST(LocalStream, ConnectsToASocketByItsPath) {
  const tests::ScratchFolder folder;
  boost::asio::io_context io;
  stream_protocol::acceptor acceptor(io, stream_protocol::endpoint((folder / "socket").string()));
  const auto stream = open_local_stream((folder / "socket").string());
  stream_protocol::socket device = acceptor.accept();
  boost::asio::write(device, boost::asio::buffer(counting_bytes(100)));
  EXPECT_EQ(read_bytes(*stream, 100), counting_bytes(100));
}

TEST(LocalStream, SaysThatNobodyListens) {
  const tests::ScratchFolder folder;
  try {
    open_local_stream((folder / "nobody").string());
    FAIL() << "it opened";
  } catch (const TransportError& error) {
    EXPECT_EQ(error.why(), "No such file or directory");
    EXPECT_THAT(error.next_step(),
                testing::HasSubstr("--lockstep " + (folder / "nobody").string()));
  }
}

TEST(LocalStream, SaysThatAPathIsTooLong) {
  EXPECT_THROW(open_local_stream("/tmp/" + std::string(200, 'x')), TransportError);
}

}  // namespace
}  // namespace echomap::transport
