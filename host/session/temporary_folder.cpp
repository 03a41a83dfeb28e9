// SPDX-License-Identifier: MIT
#include "host/session/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace echomap::session {

TemporaryFolder::TemporaryFolder() {
  std::string path = (std::filesystem::temp_directory_path() / "echomap-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), "cannot make the folder " + path);
  }
  path_ = path;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace echomap::session
