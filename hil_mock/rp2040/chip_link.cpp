// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/chip_link.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <sys/wait.h>

namespace echomap::rp2040 {
namespace {

struct Pipe {
  runner::Descriptor out;
  runner::Descriptor in;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  runner::check_call(::pipe2(ends.data(), O_CLOEXEC), "pipe");
  return {runner::Descriptor(ends[0], "pipe"), runner::Descriptor(ends[1], "pipe")};
}

}  // namespace

template <typename T>
Message& Message::put(T value) {
  std::array<std::uint8_t, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  return *this;
}

template <typename T>
T Message::take() {
  if (bytes_.size() - at_ < sizeof(T)) {
    throw std::runtime_error("rp2040js: a message is too short");
  }
  T value{};
  std::memcpy(&value, bytes_.data() + at_, sizeof(T));
  at_ += sizeof(T);
  return value;
}

Message& Message::byte(std::uint8_t value) { return put(value); }
Message& Message::half_word(std::uint16_t value) { return put(value); }
Message& Message::word(std::uint32_t value) { return put(value); }
Message& Message::number(double value) { return put(value); }

Message& Message::block(std::span<const std::uint8_t> values) {
  word(static_cast<std::uint32_t>(values.size()));
  bytes_.insert(bytes_.end(), values.begin(), values.end());
  return *this;
}

std::uint8_t Message::take_byte() { return take<std::uint8_t>(); }
std::uint32_t Message::take_word() { return take<std::uint32_t>(); }
double Message::take_number() { return take<double>(); }

std::vector<std::uint8_t> Message::take_block() {
  std::vector<std::uint8_t> values(take_word());
  for (std::uint8_t& value : values) {
    value = take_byte();
  }
  return values;
}

void Message::clear() {
  bytes_.clear();
  at_ = 0;
}

ChipLink::ChipLink(const std::filesystem::path& image) {
  Pipe orders = make_pipe();
  Pipe events = make_pipe();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, orders.out.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, events.in.number(), STDOUT_FILENO);
  std::string node = ECHOMAP_NODE;
  std::string program = ECHOMAP_RP2040_SCRIPTS "/device.mjs";
  std::string elf = image.string();
  std::string modules = ECHOMAP_RP2040_MODULES;
  const std::array<char*, 5> arguments{
      node.data(), program.data(), elf.data(), modules.data(), nullptr};
  const int failed =
      ::posix_spawn(&pid_, node.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw std::system_error(failed, std::generic_category(), node);
  }
  to_chip_ = std::move(orders.in);
  from_chip_ = std::move(events.out);
  // A write to a child that has ended is told by the read that follows it.
  std::signal(SIGPIPE, SIG_IGN);
}

ChipLink::~ChipLink() {
  to_chip_.close();
  from_chip_.close();
  ::waitpid(pid_, nullptr, 0);
}

void ChipLink::send(const Message& message) {
  Message framed;
  framed.block(message.bytes());
  for (std::span<const std::uint8_t> rest = framed.bytes(); !rest.empty();) {
    const ssize_t written = ::write(to_chip_.number(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      throw std::runtime_error("rp2040js has ended; it has said why");
    }
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
}

Message ChipLink::receive() {
  std::array<std::uint8_t, 4> head{};
  read_exactly(head);
  std::uint32_t length = 0;
  std::memcpy(&length, head.data(), head.size());
  std::vector<std::uint8_t> bytes(length);
  read_exactly(bytes);
  return Message(std::move(bytes));
}

void ChipLink::read_exactly(std::span<std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = ::read(from_chip_.number(), bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      throw std::runtime_error("rp2040js has ended; it has said why");
    }
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
}

}  // namespace echomap::rp2040
