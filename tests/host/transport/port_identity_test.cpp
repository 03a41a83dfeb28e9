// SPDX-License-Identifier: MIT
#include "host/transport/port_identity.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/host/transport/pty_pair.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::transport {
namespace {

/// The number of a pty is given to the next program as soon as the first has gone.
TEST(PortIdentity, TakesNoPtyForTheSameUnderTheSameLink) {
  const tests::ScratchFolder folder;
  const std::string link = (folder / "robot").string();
  const PtyPair device;
  std::filesystem::create_symlink(device.name(), link);
  const PortIdentity identity(link);
  EXPECT_NE(identity.objection(), "");
  std::filesystem::remove(link);
  EXPECT_NE(identity.objection(), "");
  std::filesystem::create_symlink(device.name(), link);
  EXPECT_EQ(identity.objection(), "") << "an emulator that was started again";
}

TEST(PortIdentity, TakesABarePtyForGone) {
  const PtyPair device;
  EXPECT_NE(PortIdentity(device.name()).objection(), "");
}

TEST(PortIdentity, HasNothingAgainstAnAddress) {
  EXPECT_EQ(PortIdentity("tcp://127.0.0.1:5000").objection(), "");
  EXPECT_EQ(PortIdentity("bt://00:14:03:05:59:02").objection(), "");
}

}  // namespace
}  // namespace echomap::transport
