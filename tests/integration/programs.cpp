// SPDX-License-Identifier: MIT
#include "tests/integration/programs.hpp"

#include <csignal>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"

namespace echomap::test {
namespace {

std::vector<std::string> command_of(const std::string& name, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), ECHOMAP_BINARY_DIR "/bin/" + name);
  return arguments;
}

/// The limit of a file's size is inherited; without its signal a write fails as on a full disk.
std::vector<std::string> limited(std::vector<std::string> command, int max_file_kb) {
  constexpr int kBlocksPerKb = 2;
  const std::string script = "trap '' XFSZ; ulimit -f " +
                             std::to_string(kBlocksPerKb * max_file_kb) + "; exec \"$0\" \"$@\"";
  command.insert(command.begin(), {"/bin/sh", "-c", script});
  return command;
}

}  // namespace

Program::Program(const std::string& name,
                 std::vector<std::string> arguments,
                 const std::filesystem::path& log)
    : log_(log), process_(command_of(name, std::move(arguments)), log) {}

Program::Program(const std::string& name,
                 const std::vector<std::string>& arguments,
                 const std::filesystem::path& log,
                 int max_file_kb)
    : log_(log), process_(limited(command_of(name, arguments), max_file_kb), log) {}

Ended Program::wait(std::chrono::seconds limit) {
  const auto status = process_.wait_for(limit);
  if (!status) {
    process_.send(SIGKILL);
    ADD_FAILURE() << log_ << " belongs to a program that does not end";
  }
  return {status.value_or(-1), files::read_text_file(log_)};
}

std::string free_port() {
  boost::asio::io_context io;
  const boost::asio::ip::udp::socket socket(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  return std::to_string(socket.local_endpoint().port());
}

}  // namespace echomap::test
