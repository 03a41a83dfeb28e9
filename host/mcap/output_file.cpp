// SPDX-License-Identifier: MIT
#include "host/mcap/output_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include <sys/stat.h>

#include "host/files/atomic_file.hpp"
#include "host/mcap/crc32.hpp"

namespace echomap::mcap {

namespace {

[[noreturn]] void fail_output(const char* action, const std::filesystem::path& path, int reason) {
  throw files::FileError("cannot " + std::string(action) + " " + path.string() + ": " +
                         std::generic_category().message(reason));
}

/// Writes at `offset`; 0, or the reason why not all of it could be written.
int write_at(int descriptor, std::span<const std::uint8_t> bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      return written < 0 ? errno : ENOSPC;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return 0;
}

}  // namespace

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

void OutputFile::open(const std::filesystem::path& path) {
  if (descriptor_ >= 0) {
    throw std::logic_error("an MCAP file is opened once; it is " + path_.string());
  }
  descriptor_ = ::open(path.c_str(),
                       O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                       S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
  if (descriptor_ < 0) {
    fail_output("create", path, errno);
  }
  path_ = path;
}

void OutputFile::write_out() {
  if (descriptor_ < 0 || pending_.empty()) {
    return;
  }
  const int reason = write_at(descriptor_, pending_, written_bytes_);
  if (reason != 0) {
    // Half a block at the end would hide what is written behind it. Where even this fails, the next
    // attempt writes over it.
    [[maybe_unused]] const int status =
        ::ftruncate(descriptor_, static_cast<off_t>(written_bytes_));
    fail_output("write", path_, reason);
  }
  written_crc_ = crc();
  written_bytes_ += pending_.size();
  pending_.clear();
}

std::uint32_t OutputFile::crc() const { return crc32_of(pending_, written_crc_); }

}  // namespace echomap::mcap
