// SPDX-License-Identifier: MIT
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tests/firmware/boards/ev3/brick_program.hpp"
#include "tests/support/eventually.hpp"

namespace echomap::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

BrickStart at(const std::string& line) {
  BrickStart start;
  start.line = line;
  return start;
}

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A port of this computer that somebody listens at.
class TakenPort {
 public:
  TakenPort() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of the kernel
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listener_, generic, size) != 0 || ::listen(listener_, 1) != 0 ||
        ::getsockname(listener_, generic, &size) != 0) {
      throw std::runtime_error("no port");
    }
    port_ = ntohs(address.sin_port);
  }
  ~TakenPort() { ::close(listener_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;

  int port() const { return port_; }

 private:
  int listener_;
  int port_ = 0;
};

int free_port() { return TakenPort().port(); }

/// A connection as soon as somebody listens there.
int connection_to(int port) {
  const sockaddr_in address = loopback(port);
  int host = -1;
  const bool is_open = eventually([&] {
    ::close(host);
    host = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the interface of the kernel
    return ::connect(host, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  });
  if (!is_open) {
    throw std::runtime_error("nobody listens");
  }
  return host;
}

/// True once its other end has been closed.
bool is_hung_up(int connection) {
  std::array<char, 512> bytes{};
  ssize_t count = 0;
  while ((count = ::recv(connection, bytes.data(), bytes.size(), MSG_DONTWAIT)) > 0) {
  }
  return count == 0 || errno != EAGAIN;
}

TEST(Ev3Line, SecondHostThatConnectsByTcpTakesOverFromTheFirst) {
  const int port = free_port();
  BrickProgram program(at("tcp:" + std::to_string(port)));
  const int first = connection_to(port);
  const int end_of_first = ::fcntl(first, F_DUPFD_CLOEXEC, 0);
  program.attach(first);
  ASSERT_TRUE(program.connect(1));
  EXPECT_FALSE(is_hung_up(end_of_first));
  program.attach(connection_to(port));
  EXPECT_TRUE(program.connect(1));
  EXPECT_TRUE(eventually([&] { return is_hung_up(end_of_first); }));
  ::close(end_of_first);
  EXPECT_TRUE(program.drive(1));
}

TEST(Ev3Line, HostThatHasGoneMayComeAgainByTcp) {
  const int port = free_port();
  BrickProgram program(at("tcp:" + std::to_string(port)));
  for (int time = 0; time < 2; ++time) {
    program.attach(connection_to(port));
    EXPECT_TRUE(program.connect(1));
  }
}

TEST(Ev3Line, PortThatIsInUseIsRefusedWithWords) {
  const TakenPort taken;
  const std::string line = "tcp:" + std::to_string(taken.port());
  BrickProgram program(at(line));
  EXPECT_EQ(program.end(), 1);
  EXPECT_THAT(program.errors(),
              HasSubstr("echomap-ev3: " + line + ": cannot listen: Address already in use\n"));
}

TEST(Ev3Line, BluetoothThatTheKernelDoesNotHaveIsRefusedWithItsOwnWords) {
  constexpr int kBluetoothFamily = 31;
  constexpr int kRfcommProtocol = 3;
  const int bluetooth = ::socket(kBluetoothFamily, SOCK_STREAM | SOCK_CLOEXEC, kRfcommProtocol);
  if (bluetooth >= 0) {
    ::close(bluetooth);
    GTEST_SKIP() << "this kernel has Bluetooth";
  }
  BrickProgram program(at("rfcomm:1"));
  EXPECT_EQ(program.end(), 1);
  EXPECT_THAT(program.errors(), HasSubstr("echomap-ev3: rfcomm:1: cannot listen: "));
  EXPECT_THAT(program.errors(), Not(HasSubstr("Bad file descriptor")));
}

/// The host's end of a serial line whose other end is found under that name.
int serial_line(const std::filesystem::path& link) {
  const int host = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (host < 0 || ::grantpt(host) != 0 || ::unlockpt(host) != 0) {
    throw std::runtime_error("no pseudo-terminal");
  }
  std::filesystem::remove(link);
  std::filesystem::create_symlink(::ptsname(host), link);
  return host;
}

int lines_that_say(const std::string& text, const std::string& wanted) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(wanted, at)) != std::string::npos; ++at) {
    ++count;
  }
  return count;
}

TEST(Ev3Line, SerialDeviceIsOpenedWhenItComesAndWhenItComesAgain) {
  const ScratchFolder folder;
  const auto link = folder / "line";
  const std::string words = link.string() + ": cannot be opened yet, it is tried again: No such ";
  BrickProgram program(at("serial:" + link.string()));
  EXPECT_TRUE(eventually([&] { return lines_that_say(program.errors(), words) == 1; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  EXPECT_EQ(lines_that_say(program.errors(), words), 1) << "though it was tried twice more";
  program.attach(serial_line(link));
  EXPECT_TRUE(program.connect(1));
  const int second = serial_line(link);
  program.attach(second);  // Hangs up the first.
  EXPECT_TRUE(program.connect(1));
  EXPECT_TRUE(program.drive(1));
}

}  // namespace
}  // namespace echomap::tests
