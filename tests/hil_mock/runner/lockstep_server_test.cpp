// SPDX-License-Identifier: MIT
#include "hil_mock/runner/lockstep_server.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <poll.h>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil_mock/runner/test_host.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::runner {
namespace {

std::optional<LockstepRequest> wait_for_request(LockstepServer& server) {
  std::optional<LockstepRequest> request;
  for (int i = 0; i < 100 && !request; ++i) {
    pollfd readable{server.descriptor(), POLLIN, 0};
    ::poll(&readable, 1, 50);
    request = server.take_request();
  }
  return request;
}

TEST(LockstepRequests, AreReadStrictly) {
  EXPECT_EQ(parse_request("grant 20000 17"), LockstepRequest(Grant{20000, 17}));
  EXPECT_EQ(parse_request("quit"), LockstepRequest(Quit{}));
  EXPECT_EQ(parse_request("carry-off 2000000"), LockstepRequest(CarryOff{2'000'000}));
  EXPECT_EQ(parse_request("tell-truth"), LockstepRequest(TellTruth{}));
  EXPECT_EQ(parse_request("cut-cable 3000000"), LockstepRequest(CutCable{3'000'000}));
  EXPECT_EQ(parse_request("box 1500 -200 300"), LockstepRequest(PutBox{1500, -200, 300}));
  for (const std::string line : {"",
                                 "grant",
                                 "grant 1",
                                 "grant 1 -2",
                                 "grant 1 2 3",
                                 "grant  1 2",
                                 "grant x 2",
                                 "grant 9223372036854776 2",
                                 "carry-off",
                                 "carry-off 0",
                                 "carry-off 1 2",
                                 "carry-off 4000000000",
                                 "tell-truth 1",
                                 "cut-cable",
                                 "cut-cable -1",
                                 "cut-cable 4000000000",
                                 "box",
                                 "box 1 2",
                                 "box 1 2 0",
                                 "box 1 2 3 4",
                                 "box 1.5 2 3",
                                 "box 2000000 2 3",
                                 "box -9223372036854775808 2 3",
                                 "box 1 2 10001",
                                 "quit ",
                                 "quit!"}) {
    EXPECT_EQ(parse_request(line), LockstepRequest(BadRequest{line})) << line;
  }
}

TEST(LockstepServer, GreetsTakesGrantsAndAnswers) {
  const tests::ScratchFolder folder;
  LockstepServer server(folder / "lockstep", R"({"lockstep":1})");
  TestHost host = TestHost::connect_local(folder / "lockstep");
  host.write("grant 1000 0\ngrant 2000 5\nqu");
  EXPECT_EQ(wait_for_request(server), LockstepRequest(Grant{1000, 0}));
  EXPECT_EQ(host.read_line(), R"({"lockstep":1})");
  server.send_reached(1000, 42);
  EXPECT_EQ(host.read_line(), "reached 1000 42");
  server.send_reached(1000, 42, geometry::Pose2(1.5, -0.0000014, -0.5 * std::numbers::pi));
  EXPECT_EQ(host.read_line(), "reached 1000 42 1500000 -1 -90000000");
  EXPECT_EQ(wait_for_request(server), LockstepRequest(Grant{2000, 5}));
  EXPECT_EQ(server.take_request(), std::nullopt) << "half a line is none";
  host.write("it\n");
  EXPECT_EQ(wait_for_request(server), LockstepRequest(Quit{}));
  server.send_bye();
  EXPECT_EQ(host.read_line(), "bye");
}

TEST(LockstepServer, LastWordsOfAHostThatIsGoneStillCount) {
  const tests::ScratchFolder folder;
  LockstepServer server(folder / "lockstep", "hello");
  TestHost host = TestHost::connect_local(folder / "lockstep");
  host.write("grant 1000 0\n");
  host.close();
  EXPECT_EQ(wait_for_request(server), LockstepRequest(Grant{1000, 0}));
  server.send_reached(1000, 0);
  EXPECT_EQ(wait_for_request(server), LockstepRequest(HostGone{}));
}

TEST(LockstepServer, LeavesAFileThatIsNoSocketAlone) {
  const tests::ScratchFolder folder;
  std::ofstream(folder / "notes") << "mine";
  EXPECT_THROW(LockstepServer(folder / "notes", "hello"), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(folder / "notes"), 4U);
}

TEST(LockstepServer, RemovesItsSocket) {
  const tests::ScratchFolder folder;
  {
    const LockstepServer server(folder / "lockstep", "hello");
    EXPECT_TRUE(std::filesystem::is_socket(folder / "lockstep"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "lockstep"));
}

}  // namespace
}  // namespace echomap::runner
