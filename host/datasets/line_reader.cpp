// SPDX-License-Identifier: MIT
#include "host/datasets/line_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>
#include <zlib.h>

#include "host/files/atomic_file.hpp"

namespace echomap::datasets {
namespace {

constexpr std::size_t kBufferBytes = 2 * LineReader::kMaxLineBytes;

[[noreturn]] void fail_to_open(const std::filesystem::path& path, int reason) {
  throw files::FileError("cannot read " + path.string() + ": " +
                         std::generic_category().message(reason));
}

}  // namespace

LineReader::LineReader(std::filesystem::path path, Role role)
    : path_(std::move(path)), role_(role) {
  std::error_code error;
  if (std::filesystem::is_directory(path_, error)) {
    fail_to_open(path_, EISDIR);
  }
  file_.reset(::gzopen(path_.c_str(), "rbe"));
  if (file_ == nullptr) {
    fail_to_open(path_, errno);
  }
  ::gzbuffer(file_.get(), kBufferBytes);
  const auto bytes = std::filesystem::file_size(path_, error);
  file_bytes_ = error ? 0.0 : static_cast<double>(bytes);
  buffer_.resize(kBufferBytes);
}

void LineReader::Close::operator()(gzFile_s* file) const { ::gzclose(file); }

std::optional<std::string_view> LineReader::next() {
  std::size_t searched = 0;
  while (true) {
    const char* first = buffer_.data() + begin_;
    const std::size_t held = end_ - begin_;
    const void* newline = std::memchr(first + searched, '\n', held - searched);
    const bool is_whole = newline != nullptr;
    const std::size_t length =
        is_whole ? static_cast<std::size_t>(static_cast<const char*>(newline) - first) : held;
    const bool is_given = is_whole || length > kMaxLineBytes;
    const bool is_at_end = !is_given && !fill();
    if (is_given || is_at_end) {
      if (!is_whole && length == 0) {
        return std::nullopt;
      }
      lacks_end_ = is_at_end;
      ++line_number_;
      const std::string_view line(buffer_.data() + begin_, length);
      begin_ += length + (is_whole ? 1 : 0);
      return checked(line);
    }
    searched = held;
  }
}

bool LineReader::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  const int got =
      ::gzread(file_.get(), buffer_.data() + end_, static_cast<unsigned>(buffer_.size() - end_));
  int status = Z_OK;
  const std::string_view reason = ::gzerror(file_.get(), &status);
  if (got < 0 || (got == 0 && status != Z_OK && status != Z_STREAM_END)) {
    // zlib puts the path before its reason.
    const std::string why = status == Z_ERRNO ? " " + std::generic_category().message(errno)
                                              : std::string(reason.substr(reason.rfind(':') + 1));
    throw files::FileError(path_.string() + ":" + std::to_string(line_number_ + 1) +
                           ": cannot read on:" + why);
  }
  end_ += static_cast<std::size_t>(got);
  return got > 0;
}

std::string_view LineReader::checked(std::string_view line) const {
  if (line.size() > kMaxLineBytes) {
    fail("the line is longer than " + std::to_string(kMaxLineBytes) + " bytes, not a log");
  }
  if (line.find('\0') != std::string_view::npos) {
    fail("the line contains a zero byte: not a text file");
  }
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

double LineReader::progress() const {
  const auto offset = static_cast<double>(::gzoffset(file_.get()));
  return file_bytes_ > 0.0 ? std::clamp(offset / file_bytes_, 0.0, 1.0) : 0.0;
}

void LineReader::fail(const std::string& message) const {
  const std::string text = path_.string() + ":" + std::to_string(line_number_) + ": " + message;
  if (role_ == Role::kMain && lacks_end_ && line_number_ > 1) {
    throw CutOffLine(text);
  }
  throw files::FileError(text);
}

}  // namespace echomap::datasets
