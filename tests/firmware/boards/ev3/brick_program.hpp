// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/firmware/boards/ev3/brick_folder.hpp"

namespace echomap::tests {

/// How a program is started.
struct BrickStart {
  std::string line = "stdio";
  std::vector<std::string> more = {};  ///< Further arguments.
  bool children_are_ignored = false;   ///< As by who starts it with SIGCHLD ignored.
  std::function<void(BrickFolder&)> prepare = nullptr;  ///< What else is plugged in.
};

/// The EV3's program under qemu-arm in real time, with files in the place of sysfs, and the host at
/// its standard input and output, unless it is attached to something else.
class BrickProgram {
 public:
  explicit BrickProgram(const BrickStart& start = {});
  ~BrickProgram();
  BrickProgram(const BrickProgram&) = delete;
  BrickProgram& operator=(const BrickProgram&) = delete;

  /// Says Hello until it is answered; nothing within ten seconds.
  std::optional<protocol::HelloReply> connect(std::uint16_t session);
  /// Connects, arms it and tells it to drive until its motors run; false where they do not.
  bool drive(std::uint16_t session);
  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, next_seq_++);
    write({frame.data, frame.data + frame.size});
  }
  /// The host's end of another line, which it owns from now on; what was said before is forgotten.
  void attach(int descriptor);
  /// Hangs up, and takes what it has said for the last time.
  void hang_up();

  /// The process that was started, and the one that it has started.
  pid_t guard() const { return guard_; }
  pid_t robot() const;
  /// The same once it lives, which takes a start that long; throws where it does not within ten
  /// seconds. A signal to process 0 would be one to this test.
  pid_t living_robot() const;
  /// False of one that is dead, whether or not its parent has taken note.
  static bool lives(pid_t process);
  /// By which `killall` finds it.
  static std::string name_of(pid_t process);
  /// Its exit status within ten seconds.
  std::optional<int> end();

  /// What it has said on stderr, and what it has put out and nobody has taken.
  std::string errors() const;
  std::string output() const;
  /// A file next to those of its sysfs.
  std::filesystem::path file(const std::string& name) const { return brick_.sysfs() / name; }

  /// Does it, and waits until both wheels are told to stop: how long that took; nothing in a
  /// minute.
  std::optional<double> ms_until_stopped(const std::function<void()>& harm);

  template <class M>
  void operator()(const M& message) {
    on_message(message);
  }

 private:
  template <class M>
  void on_message(const M& /*message*/) {}
  void on_message(const protocol::HelloReply& message) { reply_ = message; }
  void write(const std::vector<std::uint8_t>& bytes) const;
  void listen(std::chrono::milliseconds most);
  static bool says(const std::filesystem::path& motor, const std::string& command);

  BrickFolder brick_;
  std::filesystem::path pan_ = brick_.add_motor(3, "ev3-ports:outA");
  std::filesystem::path left_ = brick_.add_motor(5, "ev3-ports:outB");
  std::filesystem::path right_ = brick_.add_motor(0, "ev3-ports:outC");
  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  std::uint8_t next_seq_ = 0;
  std::optional<protocol::HelloReply> reply_;
  pid_t guard_ = -1;
  int input_ = -1;
  int output_ = -1;
  std::optional<int> status_;
};

}  // namespace echomap::tests
