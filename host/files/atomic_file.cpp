// SPDX-License-Identifier: MIT
#include "host/files/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace echomap::files {

namespace {

/// Throws FileError with the reason in errno.
[[noreturn]] void fail(const char* action, const std::filesystem::path& path) {
  const int reason = errno;
  throw FileError("cannot " + std::string(action) + " " + path.string() + ": " +
                  std::generic_category().message(reason));
}

/// False with the reason in errno where not all of it could be written.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return true;
}

/// The same. Pipes and devices cannot be flushed, and need not be.
bool flush(int descriptor) { return ::fsync(descriptor) == 0 || errno == EINVAL; }

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path, Readers readers)
    : path_(std::move(path)), temporary_path_(path_.string() + ".part") {
  const mode_t others = readers == Readers::kAll ? S_IRGRP | S_IROTH : 0;
  if (readers == Readers::kOwner) {
    // What an earlier program has left may be readable by others.
    ::unlink(temporary_path_.c_str());
  }
  descriptor_ = ::open(temporary_path_.c_str(),
                       O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                       S_IRUSR | S_IWUSR | others);
  if (descriptor_ < 0) {
    fail("create", path_);
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(temporary_path_.c_str());
  }
}

void AtomicFile::write(std::string_view text) {
  if (!write_all(descriptor_, text)) {
    fail("write", path_);
  }
}

void AtomicFile::write(std::span<const unsigned char> bytes) {
  write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void AtomicFile::commit() {
  if (!flush(descriptor_)) {
    fail("write", path_);
  }
  if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
    fail("rename", path_);
  }
  ::close(std::exchange(descriptor_, -1));
}

void write_text_file(const std::filesystem::path& path, std::string_view text, Readers readers) {
  AtomicFile file(path, readers);
  file.write(text);
  file.commit();
}

std::string read_text_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream.is_open() || stream.bad() || std::filesystem::is_directory(path)) {
    throw FileError("cannot read " + path.string() + ": " +
                    std::generic_category().message(stream.is_open() ? EISDIR : errno));
  }
  return text.str();
}

}  // namespace echomap::files
