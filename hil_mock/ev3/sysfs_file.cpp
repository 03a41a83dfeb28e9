// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/sysfs_file.hpp"

#include <array>
#include <charconv>
#include <fcntl.h>
#include <stdexcept>
#include <unistd.h>

namespace echomap::ev3 {
namespace {

constexpr int kEveryoneReads = 0644;
constexpr std::size_t kLongestLine = 64;

}  // namespace

SysfsFile::SysfsFile(const std::filesystem::path& path, std::string_view text)
    : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, kEveryoneReads),
            path.string()),
      name_(path.parent_path().filename().string() + "/" + path.filename().string()),
      shown_(1, '\n') {
  show(text);
}

void SysfsFile::show(std::string_view text) {
  if (shown_ == text && !has_changed()) {
    return;
  }
  shown_ = text;
  const std::string line = shown_ + "\n";
  const auto size = static_cast<off_t>(line.size());
  runner::check_call(::pwrite(file_.number(), line.data(), line.size(), 0) == size ? 0 : -1, name_);
  runner::check_call(::ftruncate(file_.number(), size), name_);
}

std::string SysfsFile::text() const {
  std::array<char, kLongestLine> bytes{};
  const auto count = ::pread(file_.number(), bytes.data(), bytes.size(), 0);
  runner::check_call(static_cast<int>(count), name_);
  const std::string_view all(bytes.data(), static_cast<std::size_t>(count));
  return std::string(all.substr(0, all.find('\n')));
}

long SysfsFile::number() const {
  const std::string digits = text();
  long number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw std::runtime_error(name_ + ": '" + digits + "' is no number (EINVAL)");
  }
  return number;
}

}  // namespace echomap::ev3
