// SPDX-License-Identifier: MIT
// Stands for the firmware: sleeps in milliseconds of simulated time and does what lines on its
// standard input say: "w FILE TEXT" writes, "r FILE" answers with a file's line, "t" with the time,
// "s US" sleeps until then, "x" ends it, "h" hangs.
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <string>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

namespace {

constexpr std::uint64_t kMsUs = 1000;
constexpr int kEndStatus = 3;

std::string sysfs;
std::uint64_t until_us = 0;

std::uint64_t hear_time(int socket) {
  std::uint64_t now_us = 0;
  if (::recv(socket, &now_us, sizeof now_us, MSG_WAITALL) != sizeof now_us) {
    ::_exit(0);
  }
  return now_us;
}

void obey(const std::string& line, std::uint64_t now_us) {
  const auto space = line.find(' ', 2);
  const std::string path =
      sysfs + "/class/" + line.substr(std::min<std::size_t>(2, line.size()), space - 2);
  switch (line.front()) {
    case 'w': {
      const int file = ::open(path.c_str(), O_WRONLY);
      const std::string text = line.substr(space + 1) + "\n";
      if (::pwrite(file, text.data(), text.size(), 0) < 0) {
        ::_exit(1);
      }
      ::close(file);
      break;
    }
    case 'r': {
      std::string text;
      std::getline(std::ifstream(path), text);
      std::cout << text << std::endl;
      break;
    }
    case 't':
      std::cout << now_us << std::endl;
      break;
    case 's':
      until_us = std::stoull(line.substr(2));
      break;
    case 'h':
      for (;;) {
        ::pause();
      }
    default:
      ::_exit(kEndStatus);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string clock;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--sysfs") == 0) {
      sysfs = argv[i + 1];
    } else if (std::strcmp(argv[i], "--clock") == 0) {
      clock = argv[i + 1] + std::strlen("unix:");
    }
  }
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, clock.c_str(), sizeof address.sun_path - 1);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    return 1;
  }
  ::fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
  std::string heard;
  for (;;) {
    const std::uint64_t now_us = hear_time(socket);
    char byte = 0;
    while (::read(STDIN_FILENO, &byte, 1) == 1) {
      if (byte != '\n') {
        heard += byte;
        continue;
      }
      obey(heard, now_us);
      heard.clear();
    }
    const std::uint64_t wake_us = until_us > now_us ? until_us : now_us + kMsUs;
    if (::send(socket, &wake_us, sizeof wake_us, MSG_NOSIGNAL) != sizeof wake_us) {
      return 1;
    }
  }
}
