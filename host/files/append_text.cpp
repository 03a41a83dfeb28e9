// SPDX-License-Identifier: MIT
#include "host/files/append_text.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

#include "host/files/atomic_file.hpp"

namespace echomap::files {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int reason) {
  throw FileError("cannot write " + path.string() + ": " + std::generic_category().message(reason));
}

/// 0, or why not all of it could be written.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
}

}  // namespace

void append_text(const std::filesystem::path& path, std::string_view text) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) {
    fail(path, errno);
  }
  const int reason = write_all(descriptor, text);
  ::close(descriptor);
  if (reason != 0) {
    fail(path, reason);
  }
}

}  // namespace echomap::files
