// SPDX-License-Identifier: MIT
#include "host/transport/port_identity.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "host/transport/transport_error.hpp"
#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

/// The port's name now, or why it has none.
std::string whereabouts(const PortIdentity& identity) {
  try {
    return identity.name_now();
  } catch (const TransportError& error) {
    return error.why();
  }
}

/// The number of a pty is given to the next program as soon as the first has gone.
TEST(PortIdentity, TakesNoPtyForTheSameUnderTheSameLink) {
  const tests::ScratchFolder folder;
  const std::string link = (folder / "robot").string();
  const PtyPair device;
  std::filesystem::create_symlink(device.name(), link);
  const PortIdentity identity(link);
  EXPECT_THROW(identity.name_now(), TransportError);
  std::filesystem::remove(link);
  std::filesystem::create_symlink(device.name(), link);
  EXPECT_EQ(whereabouts(identity), link) << "an emulator that was started again";
}

TEST(PortIdentity, TakesABarePtyForGone) {
  const PtyPair device;
  EXPECT_EQ(whereabouts(PortIdentity(device.name())), "the program at its other end is gone");
}

TEST(PortIdentity, HasNothingAgainstAnAddress) {
  for (const char* address : {"tcp://127.0.0.1:5000", "bt://00:14:03:05:59:02"}) {
    EXPECT_EQ(whereabouts(PortIdentity(address)), address);
  }
}

/// USB ports that come and go.
class UsbPortIdentity : public testing::Test {
 protected:
  static constexpr const char* kFirst = "/dev/ttyACM0";
  static constexpr const char* kSecond = "/dev/ttyACM1";

  PortIdentity identity_of(const PortInfo& port) {
    here = {port};
    return PortIdentity(port.name, [this] { return here; });
  }

  std::vector<PortInfo> here;
};

TEST_F(UsbPortIdentity, FindsADeviceUnderAnyNameByItsSerialNumber) {
  const auto identity = identity_of({kFirst, "Uno", "7543"});
  EXPECT_EQ(whereabouts(identity), kFirst);
  here = {};
  EXPECT_EQ(whereabouts(identity), "it is not plugged in");
  here = {{kSecond, "Uno", "7543"}};
  EXPECT_EQ(whereabouts(identity), kSecond);
  here = {{kFirst, "Modem", "1"}, {kSecond, "Uno", "7543"}};
  EXPECT_EQ(whereabouts(identity), kSecond);
}

TEST_F(UsbPortIdentity, TakesNoOtherDeviceForIt) {
  const auto identity = identity_of({kFirst, "Uno", "7543"});
  here = {{kFirst, "Uno", "9999"}};
  EXPECT_EQ(whereabouts(identity), "another device has its name now");
  here = {{kSecond, "Uno", "9999"}};
  EXPECT_EQ(whereabouts(identity), "it is not plugged in");
}

/// A CH340 has no number: its socket tells it from its twins.
TEST_F(UsbPortIdentity, FindsADeviceWithoutASerialNumberByItsSocket) {
  const UsbId ch340{0x1a86, 0x7523};
  const auto identity = identity_of({kFirst, "USB Serial", "", ch340, "1-1.2:1.0"});
  EXPECT_EQ(whereabouts(identity), kFirst);
  here = {{kSecond, "USB Serial", "", ch340, "1-1.2:1.0"}};
  EXPECT_EQ(whereabouts(identity), kSecond);
  here = {{kFirst, "USB Serial", "", ch340, "1-1.3:1.0"}};
  EXPECT_EQ(whereabouts(identity), "another device has its name now") << "a twin beside it";
  here.push_back({kSecond, "USB Serial", "", ch340, "1-1.2:1.0"});
  EXPECT_EQ(whereabouts(identity), kSecond);
  here = {{kFirst, "USB Serial", "", UsbId{0x0403, 0x6001}, "1-1.2:1.0"}};
  EXPECT_EQ(whereabouts(identity), "another device has its name now") << "in its socket";
}

TEST_F(UsbPortIdentity, TakesTheNumberOfEveryCp2102ForNone) {
  const UsbId cp2102{0x10c4, 0xea60};
  const auto identity = identity_of({kFirst, "CP2102", "0001", cp2102, "1-1.2:1.0"});
  here = {{kSecond, "CP2102", "0001", cp2102, "1-1.3:1.0"}};
  EXPECT_EQ(whereabouts(identity), "it is not plugged in");
}

TEST_F(UsbPortIdentity, TakesNoOtherPortOfTheSameDevice) {
  const auto identity = identity_of({kFirst, "Dual", "77", UsbId{0x2e8a, 0xa}, "1-1:1.0"});
  here = {{kFirst, "Dual", "77", UsbId{0x2e8a, 0xa}, "1-1:1.2"},
          {kSecond, "Dual", "77", UsbId{0x2e8a, 0xa}, "1-1:1.0"}};
  EXPECT_EQ(whereabouts(identity), kSecond);
}

TEST_F(UsbPortIdentity, GuessesNothingOfADeviceWithoutASerialNumber) {
  const auto identity = identity_of({kFirst, "USB Serial", ""});
  EXPECT_EQ(whereabouts(identity), kFirst);
  here = {{kSecond, "USB Serial", ""}};
  EXPECT_EQ(whereabouts(identity), "it is not plugged in") << "it may be a twin of it";
}

}  // namespace
}  // namespace echomap::transport
