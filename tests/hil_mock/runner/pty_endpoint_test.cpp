// SPDX-License-Identifier: MIT
#include "hil_mock/runner/pty_endpoint.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/endpoint_text.hpp"
#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

namespace fs = std::filesystem;

TEST(PtyEndpoint, EveryByteValuePassesBothWays) {
  const tests::ScratchFolder folder;
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kDrop);
  TestHost host = TestHost::open_terminal(endpoint.address());
  host.write(all_bytes());
  EXPECT_EQ(receive_all(endpoint, 256), all_bytes());
  send_text(endpoint, all_bytes());
  EXPECT_EQ(host.read(256), all_bytes());
}

TEST(PtyEndpoint, HostsMayComeAndGo) {
  const tests::ScratchFolder folder;
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kDrop);
  for (const std::string text : {"first", "second", "third"}) {
    TestHost host = TestHost::open_terminal(endpoint.address());
    host.write(text);
    EXPECT_EQ(receive_all(endpoint, text.size()), text);
    send_text(endpoint, text);
    EXPECT_EQ(host.read(text.size()), text);
  }
}

TEST(PtyEndpoint, WhatNobodyReadsIsDroppedAndCounted) {
  const tests::ScratchFolder folder;
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kDrop);
  for (int i = 0; i < 100; ++i) {
    send_text(endpoint, std::string(1000, 'x'));
  }
  EXPECT_GT(endpoint.dropped_bytes(), 50'000U);
  EXPECT_LT(endpoint.dropped_bytes(), 100'000U);
}

TEST(PtyEndpoint, InLockstepNothingIsLost) {
  const tests::ScratchFolder folder;
  PtyEndpoint endpoint(folder / "robot", WhenUnread::kKeep);
  TestHost host = TestHost::open_terminal(endpoint.address());
  std::string sent;
  for (int i = 0; i < 100; ++i) {
    sent += all_bytes();
    send_text(endpoint, all_bytes());
  }
  std::string arrived;
  while (arrived.size() < sent.size()) {
    const std::string piece = host.read(256);
    ASSERT_EQ(piece.size(), 256U);
    arrived += piece;
    endpoint.send({});
  }
  EXPECT_EQ(arrived, sent);
  EXPECT_FALSE(endpoint.is_sending());
}

TEST(PtyEndpoint, TakesOverAnOldLinkAndRemovesItsOwn) {
  const tests::ScratchFolder folder;
  fs::create_symlink("/dev/pts/none", folder / "robot");
  {
    const PtyEndpoint endpoint(folder / "robot", WhenUnread::kDrop);
    EXPECT_EQ(fs::read_symlink(folder / "robot").string().rfind("/dev/pts/", 0), 0U);
    EXPECT_TRUE(fs::exists(folder / "robot"));
  }
  EXPECT_FALSE(fs::is_symlink(folder / "robot"));
}

TEST(PtyEndpoint, LeavesAFileThatIsNoLinkAlone) {
  const tests::ScratchFolder folder;
  std::ofstream(folder / "robot") << "precious";
  EXPECT_THROW(PtyEndpoint(folder / "robot", WhenUnread::kDrop), std::runtime_error);
  EXPECT_EQ(fs::file_size(folder / "robot"), 8U);
}

}  // namespace
}  // namespace echomap::runner
