// SPDX-License-Identifier: MIT
#include "host/transport/port_lock.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/poll.h>

#include "host/transport/file_descriptor.hpp"
#include "host/transport/pty_port.hpp"
#include "host/transport/serial_port.hpp"
#include "tests/host/transport/line_settings.hpp"
#include "tests/host/transport/modem_lines.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/port_keeper.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

using testing::HasSubstr;
using tests::PortKeeper;
using tests::PortKeeping;

std::string refusal_of(const std::string& port) {
  try {
    const FileDescriptor opened(open_port_alone(port));
    return "it opened";
  } catch (const PortHeldError& error) {
    return error.what();
  }
}

TEST(PortLock, NamesTheProcessThatHasAPty) {
  for (const auto keeping : {PortKeeping::kFlock, PortKeeping::kTiocexcl}) {
    const PtyPair device;
    const PortKeeper keeper(device.name(), keeping);
    EXPECT_THAT(refusal_of(device.name()),
                HasSubstr("process " + std::to_string(keeper.pid()) + " ("))
        << int(keeping);
    EXPECT_THAT(refusal_of(device.name()), HasSubstr("next: "));
  }
}

/// Not the emulator, which has its own pty open.
TEST(PortLock, NamesTheProcessThatHasLockedAPtyAmongThoseThatHaveItOpen) {
  const PtyPair device;
  const PortKeeper early(device.name(), PortKeeping::kNotAtAll);
  const PortKeeper keeper(device.name(), PortKeeping::kFlock);
  const PortKeeper late(device.name(), PortKeeping::kNotAtAll);
  EXPECT_THAT(refusal_of(device.name()),
              HasSubstr("process " + std::to_string(keeper.pid()) + " ("));
}

TEST(PortLock, LeavesThePortOfAnotherAsItIs) {
  PtyPair device;
  modem_lines() = {};
  const PortKeeper keeper(device.name(), PortKeeping::kFlock);
  const FileDescriptor host(::open(device.name().c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK));
  device.write(counting_bytes(5));
  pollfd readable{host.get(), POLLIN, 0};
  ASSERT_EQ(::poll(&readable, 1, 5000), 1);
  const LineSettings before = line_settings(device.fd());
  EXPECT_THROW(open_pty_port(device.name()), PortHeldError);
  EXPECT_THROW(open_serial_port(device.name(), 9600), PortHeldError);
  EXPECT_EQ(line_settings(device.fd()).baud, before.baud);
  EXPECT_EQ(modem_lines().falls_of_dtr, 0);
  std::array<char, 16> unread{};
  EXPECT_EQ(::read(host.get(), unread.data(), unread.size()), 5) << "nothing was flushed";
}

/// An emulated robot may hold the end that it offers.
TEST(PortLock, TakesAPtyThatAnotherOnlyHasOpen) {
  const PtyPair device;
  const PortKeeper keeper(device.name(), PortKeeping::kNotAtAll);
  EXPECT_EQ(refusal_of(device.name()), "it opened");
}

TEST(PortLock, IsNotOpenedToAskWhoHasIt) {
  const PtyPair device;
  EXPECT_NO_THROW(refuse_if_held(device.name()));
  const PortKeeper keeper(device.name(), PortKeeping::kNotAtAll);
  EXPECT_THROW(refuse_if_held(device.name()), PortHeldError);
}

TEST(PortLock, IsThisProcesssOwnAsLongAsItIsOpen) {
  const PtyPair device;
  {
    const auto port = open_pty_port(device.name());
    EXPECT_THAT(refusal_of(device.name()), HasSubstr("this program has it open already"));
    EXPECT_THROW(PortKeeper(device.name(), PortKeeping::kFlock), std::runtime_error);
  }
  EXPECT_EQ(refusal_of(device.name()), "it opened");
}

TEST(PortLock, OfASerialPortEndsWithIt) {
  const PtyPair device;
  {
    const auto port = open_serial_port(device.name(), 115200);
    EXPECT_THAT(refusal_of(device.name()), HasSubstr("this program has it open already"));
  }
  EXPECT_EQ(refusal_of(device.name()), "it opened");
}

TEST(PortLock, EndsWithAProcessThatIsKilled) {
  const PtyPair device;
  auto keeper = std::make_unique<PortKeeper>(device.name(), PortKeeping::kFlock);
  EXPECT_NE(refusal_of(device.name()), "it opened");
  keeper.reset();
  EXPECT_EQ(refusal_of(device.name()), "it opened");
}

TEST(PortLock, IsForWhatALinkLeadsTo) {
  const PtyPair device;
  const tests::ScratchFolder folder;
  const std::string link = (folder / "robot").string();
  std::filesystem::create_symlink(device.name(), link);
  const PortKeeper keeper(device.name(), PortKeeping::kFlock);
  EXPECT_THAT(refusal_of(link), HasSubstr("cannot open " + link + ": process "));
}

TEST(PortLock, HasNothingToSayOfAPortThatIsNotThere) {
  EXPECT_EQ(open_port_alone("/dev/ttyNOBODY7"), -1);
  EXPECT_EQ(errno, ENOENT);
}

}  // namespace
}  // namespace echomap::transport
