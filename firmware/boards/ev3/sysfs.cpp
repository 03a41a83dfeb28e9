// SPDX-License-Identifier: MIT
#include "firmware/boards/ev3/sysfs.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

namespace echomap {
namespace boards {
namespace {

constexpr size_t kWordBytes = 64;
/// "-2147483648", a new line and the end.
constexpr size_t kNumberBytes = 13;

/// "outA", or "ev3-ports:outA" as newer kernels say.
bool is_port(const char* address, const char* port) {
  const size_t length = strlen(address);
  const size_t wanted = strlen(port);
  return length >= wanted && strcmp(address + length - wanted, port) == 0 &&
         (length == wanted || address[length - wanted - 1] == ':');
}

bool join(char* path, const char* folder, const char* name) {
  const int length = snprintf(path, kPathBytes, "%s/%s", folder, name);
  return length > 0 && static_cast<size_t>(length) < kPathBytes;
}

int flag_of(Access access) {
  if (access == Access::kReadAndWrite) {
    return O_RDWR;
  }
  return access == Access::kRead ? O_RDONLY : O_WRONLY;
}

bool is_plugged_into(const DeviceFolder& folder, const char* port) {
  char path[kPathBytes];
  char address[kWordBytes];
  if (!join(path, folder.path, "address")) {
    return false;
  }
  const int file = ::open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return false;
  }
  const ssize_t count = ::read(file, address, sizeof address - 1);
  close(file);
  address[count > 0 ? count : 0] = '\0';
  address[strcspn(address, "\n")] = '\0';
  return is_port(address, port);
}

}  // namespace

bool find_device(const char* sysfs,
                 const char* class_name,
                 const char* port,
                 DeviceFolder& folder) {
  char path[kPathBytes];
  const int length = snprintf(path, sizeof path, "%s/class/%s", sysfs, class_name);
  if (length < 0 || static_cast<size_t>(length) >= sizeof path) {
    return false;
  }
  DIR* const devices = opendir(path);
  if (devices == nullptr) {
    return false;
  }
  bool found = false;
  while (const dirent* const entry = found ? nullptr : readdir(devices)) {
    found = entry->d_name[0] != '.' && join(folder.path, path, entry->d_name) &&
            is_plugged_into(folder, port);
  }
  closedir(devices);
  return found;
}

bool Attribute::open(const DeviceFolder& folder, const char* name, Access access) {
  char path[kPathBytes];
  file_ = join(path, folder.path, name) ? ::open(path, flag_of(access) | O_CLOEXEC) : -1;
  return is_open();
}

bool Attribute::read_word(char* word, size_t size) const {
  const ssize_t count = file_ < 0 ? -1 : pread(file_, word, size - 1, 0);
  word[count > 0 ? count : 0] = '\0';
  word[strcspn(word, "\n ")] = '\0';
  return count > 0;
}

bool Attribute::read(int32_t& number) const {
  char word[kNumberBytes];
  if (!read_word(word, sizeof word)) {
    return false;
  }
  const bool is_negative = word[0] == '-';
  const char* digit = is_negative ? word + 1 : word;
  if (*digit < '0' || *digit > '9') {
    return false;
  }
  uint32_t size = 0;
  for (; *digit >= '0' && *digit <= '9'; ++digit) {
    size = size * 10 + static_cast<uint32_t>(*digit - '0');
  }
  number = static_cast<int32_t>(is_negative ? 0 - size : size);
  return true;
}

bool Attribute::write(const char* text) const {
  const ssize_t length = static_cast<ssize_t>(strlen(text));
  return file_ >= 0 && pwrite(file_, text, static_cast<size_t>(length), 0) == length;
}

bool Attribute::write(int32_t number) const {
  char text[kNumberBytes];
  char* start = text + sizeof text - 1;
  *start = '\0';
  *--start = '\n';
  uint32_t size = static_cast<uint32_t>(number);
  size = number < 0 ? 0 - size : size;
  do {
    *--start = static_cast<char>('0' + size % 10);
    size /= 10;
  } while (size != 0);
  if (number < 0) {
    *--start = '-';
  }
  return write(start);
}

}  // namespace boards
}  // namespace echomap
