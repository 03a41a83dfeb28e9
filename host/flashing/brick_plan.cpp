// SPDX-License-Identifier: MIT
#include "host/flashing/brick_plan.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "host/files/atomic_file.hpp"

namespace echomap::flashing {
namespace {

constexpr int kOtherMachine = 64;

/// ssh's own option, so that a brick that is off is found out soon.
constexpr auto kConnectTimeout = "ConnectTimeout=10";

std::string check_of_machine() {
  return fmt::format("case $(uname -m) in armv5*) ;; *) uname -m; exit {};; esac", kOtherMachine);
}

/// For the death of both of the program's processes, which leaves the motors on.
constexpr auto kStopMotors =
    "echo coast | tee /sys/class/tacho-motor/*/stop_action; "
    "echo stop | tee /sys/class/tacho-motor/*/command";

/// Lines of a unit of systemd's user manager. The program restarts as a board does after its
/// watchdog, however often, with the motors stopped. What is left of it has little time to end.
std::vector<std::string> unit_lines() {
  return {"[Unit]",
          "Description=echomap",
          "StartLimitIntervalSec=0",
          "[Service]",
          fmt::format("ExecStart=%h/echomap-ev3.elf --line tcp:{}", kBrickTcpPort),
          fmt::format("ExecStopPost=-/bin/sh -c \"{}\"", kStopMotors),
          "TimeoutStopSec=5",
          "Restart=always",
          "RestartSec=1",
          "[Install]",
          "WantedBy=default.target"};
}

std::string start_script() {
  std::string script =
      "chmod +x echomap-ev3.new && mv -f echomap-ev3.new echomap-ev3.elf && "
      "mkdir -p .config/systemd/user && printf '%s\\n'";
  for (const std::string& line : unit_lines()) {
    script += " " + console::shell_line({line});
  }
  return script +
         " > .config/systemd/user/echomap.service && systemctl --user daemon-reload && "
         "systemctl --user enable echomap && systemctl --user restart echomap";
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t length) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < length; ++i) {
    number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  }
  return number;
}

/// A program header of a 32-bit ELF.
struct ElfSegment {
  std::uint32_t kind = 0;
  std::size_t begin = 0;
  std::size_t bytes = 0;
};

constexpr std::size_t kElfHeaderBytes = 52;

/// The segments of an ELF that is at least as long as its header; what is cut off is left out.
std::vector<ElfSegment> segments_of(const std::string& elf) {
  constexpr std::size_t kSegmentHeaderBytes = 32;
  const std::size_t table = number_at(elf, 28, 4);
  const std::size_t stride = number_at(elf, 42, 2);
  const std::size_t count = number_at(elf, 44, 2);
  std::vector<ElfSegment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = table + i * stride;
    if (at + kSegmentHeaderBytes <= elf.size()) {
      segments.push_back(
          {number_at(elf, at, 4), number_at(elf, at + 4, 4), number_at(elf, at + 16, 4)});
    }
  }
  return segments;
}

/// Whether it names a loader of shared libraries.
bool names_a_loader(const std::string& elf) {
  constexpr std::uint32_t kInterpreter = 3;
  return std::ranges::any_of(
      segments_of(elf), [](const ElfSegment& segment) { return segment.kind == kInterpreter; });
}

/// Whether one of the notes in a segment says that it is for Linux (NT_GNU_ABI_TAG).
bool has_linux_note(const std::string& elf, const ElfSegment& notes) {
  constexpr std::size_t kHeadBytes = 12;
  constexpr std::uint32_t kAbiTag = 1;
  constexpr std::uint32_t kLinux = 0;
  const std::string_view gnu("GNU\0", 4);
  const auto padded = [](std::size_t bytes) { return (bytes + 3) / 4 * 4; };
  const std::size_t end = std::min(notes.begin + notes.bytes, elf.size());
  for (std::size_t at = notes.begin; at + kHeadBytes <= end;) {
    const std::size_t name_bytes = number_at(elf, at, 4);
    const std::size_t tag_bytes = number_at(elf, at + 4, 4);
    const std::size_t name = at + kHeadBytes;
    const std::size_t tag = name + padded(name_bytes);
    if (number_at(elf, at + 8, 4) == kAbiTag && tag + 4 <= end &&
        std::string_view(elf).substr(name, name_bytes) == gnu && number_at(elf, tag, 4) == kLinux) {
      return true;
    }
    at = tag + padded(tag_bytes);
  }
  return false;
}

bool is_for_linux(const std::string& elf) {
  constexpr std::uint32_t kNotes = 4;
  return std::ranges::any_of(segments_of(elf), [&](const ElfSegment& segment) {
    return segment.kind == kNotes && has_linux_note(elf, segment);
  });
}

bool needs_a_floating_point_unit(const std::string& elf) {
  constexpr std::uint32_t kHardFloat = 0x400;
  return (number_at(elf, 36, 4) & kHardFloat) != 0;
}

}  // namespace

std::string fault_of_host(const std::string& host) {
  const auto is_fit = [](unsigned char letter) {
    return std::isalnum(letter) != 0 ||
           std::string_view("._-@").find(static_cast<char>(letter)) != std::string_view::npos;
  };
  const bool is_whole = !host.empty() && host.front() != '-' && host.front() != '@' &&
                        host.back() != '@' && std::ranges::count(host, '@') <= 1;
  return is_whole && std::ranges::all_of(host, is_fit)
             ? ""
             : "'" + host + "' is no host\n  next: write --host USER@NAME, as robot@ev3dev.local";
}

std::string fault_of_brick_program(const std::filesystem::path& program) {
  constexpr std::uint32_t kArm = 40;
  const std::string elf = files::read_text_file(program);
  // \x01\x01: of 32 bits, little-endian.
  if (elf.size() < kElfHeaderBytes ||
      !elf.starts_with("\x7f"
                       "ELF\x01\x01") ||
      number_at(elf, 18, 2) != kArm) {
    return "it is no program for the EV3's processor, a 32-bit ARM";
  }
  if (names_a_loader(elf)) {
    return "it needs shared libraries, which the brick may not have";
  }
  if (!is_for_linux(elf)) {
    return "it is no program for Linux: the firmware of another board?";
  }
  return needs_a_floating_point_unit(elf)
             ? "it needs a floating-point unit (armhf), which the EV3 lacks"
             : "";
}

BrickPlan brick_plan(const std::string& host, const std::string& program) {
  const std::string name = host.substr(host.find('@') + 1);
  BrickPlan plan{host, {}, fmt::format("tcp://{}:{}", name, kBrickTcpPort)};
  plan.steps.push_back({{"ssh", "-o", kConnectTimeout, host, check_of_machine()},
                        "ask what machine it is",
                        "does ev3dev run there? ssh " + host + " uname -a",
                        kOtherMachine,
                        host + " is no EV3: its processor is another one (above)\n"
                               "  next: name the brick with --host USER@NAME"});
  plan.steps.push_back({{"scp", "-o", kConnectTimeout, program, host + ":echomap-ev3.new"},
                        "copy the program",
                        "is there space on the brick's card? ssh " + host + " df -h"});
  plan.steps.push_back({{"ssh", "-o", kConnectTimeout, host, start_script()},
                        "start the program, now and at every login",
                        "what does systemd say? ssh " + host + " systemctl --user status echomap"});
  return plan;
}

}  // namespace echomap::flashing
