// SPDX-License-Identifier: MIT
#include "host/console/question.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/host/transport/pty_pair.hpp"

namespace echomap::console {
namespace {

/// Stdin and stderr are these while it exists.
class StandardStreams {
 public:
  StandardStreams(int input, int error)
      : stdin_(::dup(STDIN_FILENO)), stderr_(::dup(STDERR_FILENO)) {
    ::dup2(input, STDIN_FILENO);
    ::dup2(error, STDERR_FILENO);
  }
  ~StandardStreams() {
    ::dup2(stdin_, STDIN_FILENO);
    ::dup2(stderr_, STDERR_FILENO);
    ::close(stdin_);
    ::close(stderr_);
  }
  StandardStreams(const StandardStreams&) = delete;
  StandardStreams& operator=(const StandardStreams&) = delete;

 private:
  int stdin_;
  int stderr_;
};

TEST(Question, IsAskedOnATerminalAndAnsweredThere) {
  transport::PtyPair terminal;
  const transport::FileDescriptor person(::open(terminal.name().c_str(), O_RDWR | O_NOCTTY));
  constexpr std::string_view kTyped = "yes\n2\n";
  terminal.write({reinterpret_cast<const std::uint8_t*>(kTyped.data()), kTyped.size()});
  std::optional<std::string> first;
  std::optional<std::string> second;
  {
    const StandardStreams streams(person.get(), person.get());
    first = ask("Is it?");
    second = ask("Which?");
  }
  EXPECT_EQ(first, "yes");
  EXPECT_EQ(second, "2");
  const auto shown = terminal.read(14);
  EXPECT_EQ(std::string(shown.begin(), shown.end()), "Is it? Which? ");
}

TEST(Question, IsNotAskedWithoutATerminal) {
  const transport::FileDescriptor nothing(::open("/dev/null", O_RDWR));
  const StandardStreams streams(nothing.get(), nothing.get());
  EXPECT_EQ(ask("Is it?"), std::nullopt);
  EXPECT_EQ(read_line(), std::nullopt);
}

}  // namespace
}  // namespace echomap::console
