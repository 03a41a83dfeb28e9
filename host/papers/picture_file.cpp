// SPDX-License-Identifier: MIT
#include "host/papers/picture_file.hpp"

#include <string>

#include "host/files/atomic_file.hpp"

namespace echomap::papers {

std::vector<std::uint8_t> write_picture(const exports::Picture& picture,
                                        const std::filesystem::path& file,
                                        const std::vector<exports::PngText>& texts) {
  std::filesystem::create_directories(file.parent_path());
  picture.write_png(file, texts);
  const std::string bytes = files::read_text_file(file);
  return {bytes.begin(), bytes.end()};
}

}  // namespace echomap::papers
