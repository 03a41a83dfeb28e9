// SPDX-License-Identifier: MIT
#include "host/transport/open_stream.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

TEST(OpenStream, TellsTheKindOfAPortByItsName) {
  EXPECT_EQ(port_kind("tcp://robot:5000"), PortKind::kTcp);
  EXPECT_EQ(port_kind("tcp://nonsense"), PortKind::kTcp);
  EXPECT_EQ(port_kind("bt://00:14:03:05:59:02"), PortKind::kBluetooth);
  EXPECT_EQ(port_kind("/dev/pts/3"), PortKind::kPty);
  EXPECT_EQ(port_kind("/dev/ttyACM0"), PortKind::kSerial);
  EXPECT_EQ(port_kind("/dev/pts-not/3"), PortKind::kSerial);
  EXPECT_EQ(port_kind(""), PortKind::kSerial);
}

TEST(OpenStream, KnowsARadioByItsName) {
  EXPECT_TRUE(is_radio("bt://00:14:03:05:59:02"));
  EXPECT_TRUE(is_radio("/dev/rfcomm0"));
  EXPECT_FALSE(is_radio("/dev/ttyUSB0"));
  EXPECT_FALSE(is_radio("tcp://rfcomm:5000"));
}

TEST(OpenStream, FollowsTheStableLinkOfAnEmulator) {
  PtyPair device;
  const tests::ScratchFolder folder;
  const std::string link = (folder / "echomap-robot").string();
  std::filesystem::create_symlink(device.name(), link);
  EXPECT_EQ(port_kind(link), PortKind::kPty);
  const auto stream = open_stream(link, 115200);
  EXPECT_EQ(stream->name(), link);
  device.write(counting_bytes(100));
  EXPECT_EQ(read_bytes(*stream, 100), counting_bytes(100));
}

TEST(OpenStream, ThrowsForEveryKindThatIsNotThere) {
  for (const char* missing : {"tcp://127.0.0.1:1",
                              "/dev/pts/nobody",
                              "/dev/ttyNOBODY7",
                              "bt://00:00:00:00:00:00",
                              "bt://x",
                              ""}) {
    EXPECT_THROW(open_stream(missing, 115200), TransportError) << missing;
  }
}

}  // namespace
}  // namespace echomap::transport
