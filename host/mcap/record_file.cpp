// SPDX-License-Identifier: MIT
#include "host/mcap/record_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>
#include <utility>

#include "host/mcap/crc32.hpp"
#include "host/mcap/record_reader.hpp"

namespace echomap::mcap {

namespace {

[[noreturn]] void fail_input(const std::filesystem::path& path, const std::string& reason) {
  throw files::FileError("cannot read " + path.string() + ": " + reason);
}

std::uint64_t size_of_input(const std::filesystem::path& path) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) {
    fail_input(path, error.message());
  }
  return size;
}

}  // namespace

RecordFile::RecordFile(std::filesystem::path path)
    : path_(std::move(path)), size_bytes_(size_of_input(path_)), stream_(path_, std::ios::binary) {
  if (!stream_.is_open()) {
    fail_input(path_, std::generic_category().message(errno));
  }
  is_closed_by_magic_ = has_closing_magic();
  std::array<std::uint8_t, kMagic.size()> magic{};
  if (size_bytes_ >= magic.size()) {
    read_exactly(magic);
  }
  if (magic != kMagic) {
    throw files::FileError(path_.string() + ": not an MCAP file");
  }
}

bool RecordFile::has_closing_magic() {
  std::array<char, kMagic.size()> last{};
  if (size_bytes_ < 2 * last.size()) {
    return false;
  }
  stream_.seekg(static_cast<std::streamoff>(size_bytes_ - last.size()));
  stream_.read(last.data(), last.size());
  stream_.clear();
  stream_.seekg(0);
  return std::equal(last.begin(), last.end(), kMagic.begin(), [](char byte, std::uint8_t magic) {
    return static_cast<std::uint8_t>(byte) == magic;
  });
}

std::optional<RecordHead> RecordFile::next_head() {
  crc_before_record_ = crc_;
  if (position_ >= size_bytes_) {
    return std::nullopt;
  }
  RecordHead head;
  head.offset = position_;
  if (size_bytes_ - position_ < kRecordHeadBytes) {
    fail_cut_off(head.offset, "the file ends in the midst of a record");
  }
  std::array<std::uint8_t, kRecordHeadBytes> bytes{};
  read_exactly(bytes);
  RecordReader reader(bytes);
  head.opcode = static_cast<Opcode>(reader.number<std::uint8_t>());
  head.content_bytes = reader.number<std::uint64_t>();
  const std::uint64_t bytes_left = size_bytes_ - position_;
  if (head.content_bytes > bytes_left) {
    const std::string what = "a record of " + std::to_string(head.content_bytes) +
                             " bytes, of which the file has " + std::to_string(bytes_left);
    // No writer leaves a record of such a size half written: its length is damaged.
    if (head.content_bytes > kMaxRecordBytes) {
      fail(head.offset, what);
    }
    fail_cut_off(head.offset, what);
  }
  return head;
}

void RecordFile::read_content(const RecordHead& head, Bytes& content) {
  if (head.content_bytes > kMaxRecordBytes) {
    fail(head.offset,
         "a record of " + std::to_string(head.content_bytes) + " bytes; at most " +
             std::to_string(kMaxRecordBytes) + " are read");
  }
  content.resize(static_cast<std::size_t>(head.content_bytes));
  read_exactly(content);
}

void RecordFile::skip_content(const RecordHead& head) {
  // The bytes are read all the same: they count for the checksum of the data section.
  std::array<std::uint8_t, 4096> block{};
  for (std::uint64_t left = head.content_bytes; left > 0;) {
    const auto step = std::span(block).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size())));
    read_exactly(step);
    left -= step.size();
  }
}

void RecordFile::read_exactly(std::span<std::uint8_t> bytes) {
  stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (stream_.bad()) {
    fail_input(path_, "byte " + std::to_string(position_) + " and those behind it");
  }
  if (static_cast<std::size_t>(stream_.gcount()) != bytes.size()) {
    fail_cut_off(position_, "the file became shorter while it was read");
  }
  position_ += bytes.size();
  crc_ = crc32_of(bytes, crc_);
}

double RecordFile::progress() const {
  return size_bytes_ == 0 ? 1.0 : static_cast<double>(position_) / static_cast<double>(size_bytes_);
}

void RecordFile::fail(std::uint64_t offset, const std::string& what) const {
  throw files::FileError(path_.string() + ": byte " + std::to_string(offset) + ": " + what);
}

void RecordFile::fail_cut_off(std::uint64_t offset, const std::string& what) const {
  if (is_closed_by_magic_) {
    fail(offset, what + ", though the file has its end: it is damaged before");
  }
  throw CutOffFile(path_.string() + ": byte " + std::to_string(offset) + ": " + what +
                   "; everything before it was read");
}

}  // namespace echomap::mcap
