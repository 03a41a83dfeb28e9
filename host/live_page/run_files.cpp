// SPDX-License-Identifier: MIT
#include "host/live_page/run_files.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sys/stat.h>

namespace echomap::live_page {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPartBytes = std::size_t{64} << 10;

constexpr std::pair<std::string_view, std::string_view> kMediaTypes[] = {
    {".csv", "text/csv"},
    {".g2o", "text/plain"},
    {".gif", "image/gif"},
    {".json", "application/json"},
    {".mcap", "application/octet-stream"},
    {".pgm", "image/x-portable-graymap"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".toml", "application/toml"},
    {".tum", "text/plain"},
    {".txt", "text/plain"},
    {".yaml", "application/yaml"},
};

/// Hidden files, paths and files that are being written are none that a run offers.
bool is_offered(std::string_view name) {
  const bool is_plain = std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 0x20 || c == 0x7F || c == '/' || c == '\\';
  });
  return is_plain && !name.empty() && !name.starts_with('.') && !name.ends_with(".part");
}

/// A file's content, as long as it was when it was opened.
class FileBody final : public BodySource {
 public:
  FileBody(int descriptor, std::uint64_t size)
      : descriptor_(descriptor), size_(size), left_(size) {}
  ~FileBody() override { ::close(descriptor_); }
  FileBody(const FileBody&) = delete;
  FileBody& operator=(const FileBody&) = delete;

  std::uint64_t size() const override { return size_; }
  std::string next_part() override {
    std::string part(static_cast<std::size_t>(std::min<std::uint64_t>(left_, kPartBytes)), '\0');
    ssize_t count = 0;
    do {
      count = ::read(descriptor_, part.data(), part.size());
    } while (count < 0 && errno == EINTR);
    part.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    left_ -= part.size();
    return part;
  }

 private:
  int descriptor_;
  std::uint64_t size_;
  std::uint64_t left_;
};

class HistoryBody final : public BodySource {
 public:
  explicit HistoryBody(std::vector<SharedMessage> messages) : messages_(std::move(messages)) {
    for (const SharedMessage& message : messages_) {
      size_ += sizeof(std::uint32_t) + message->bytes.size();
    }
  }

  std::uint64_t size() const override { return size_; }
  std::string next_part() override {
    std::string part;
    for (; next_ < messages_.size() && part.size() < kPartBytes; ++next_) {
      const std::string& bytes = messages_[next_]->bytes;
      const auto length = static_cast<std::uint32_t>(bytes.size());
      static_assert(std::endian::native == std::endian::little);
      part.append(reinterpret_cast<const char*>(&length), sizeof length);
      part += bytes;
    }
    return part;
  }

 private:
  std::vector<SharedMessage> messages_;
  std::size_t next_ = 0;
  std::uint64_t size_ = 0;
};

}  // namespace

std::vector<RunFile> run_files(const fs::path& folder) {
  std::vector<RunFile> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    const std::string name = entry->path().filename().string();
    const std::uint64_t bytes = entry->is_symlink(gone) ? 0 : entry->file_size(gone);
    if (!gone && is_offered(name) && fs::is_regular_file(entry->symlink_status(gone))) {
      found.push_back({name, bytes});
    }
  }
  std::sort(found.begin(), found.end(), [](const RunFile& a, const RunFile& b) {
    return a.name < b.name;
  });
  return found;
}

std::unique_ptr<BodySource> open_run_file(const fs::path& folder, std::string_view name) {
  if (folder.empty() || !is_offered(name)) {
    return nullptr;
  }
  // A pipe must not be waited for, a link not be followed.
  const int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
  const int descriptor = ::open((folder / name).c_str(), flags);
  if (descriptor < 0) {
    return nullptr;
  }
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return nullptr;
  }
  return std::make_unique<FileBody>(descriptor, static_cast<std::uint64_t>(status.st_size));
}

std::string_view media_type_of(std::string_view name) {
  for (const auto& [ending, type] : kMediaTypes) {
    if (name.ends_with(ending)) {
      return type;
    }
  }
  return "application/octet-stream";
}

std::unique_ptr<BodySource> history_body(const History& history) {
  return std::make_unique<HistoryBody>(history.since(0));
}

}  // namespace echomap::live_page
