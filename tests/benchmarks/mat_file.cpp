// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mat_file.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

#include "host/files/atomic_file.hpp"

namespace echomap::bench {

namespace {

constexpr std::size_t kHeaderBytes = 128;
constexpr std::size_t kAlignment = 8;
constexpr std::uint32_t kInt32 = 5;
constexpr std::uint32_t kDouble = 9;
constexpr std::uint32_t kMatrix = 14;

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number number{};
  if (at + sizeof(Number) > bytes.size()) {
    throw files::FileError("a MATLAB file ends within a number");
  }
  std::memcpy(&number, bytes.data() + at, sizeof(Number));
  return number;
}

struct Element {
  std::uint32_t kind = 0;
  std::string_view data;
};

/// The elements that follow each other in `bytes`; those of up to four bytes stand in their tag.
std::vector<Element> elements_of(std::string_view bytes) {
  std::vector<Element> elements;
  for (std::size_t at = 0; at + kAlignment <= bytes.size();) {
    const auto tag = number_at<std::uint32_t>(bytes, at);
    const std::uint32_t small_size = tag >> 16U;
    if (small_size > 0) {
      elements.push_back({tag & 0xFFFFU, bytes.substr(at + 4, small_size)});
      at += kAlignment;
      continue;
    }
    const std::size_t size = number_at<std::uint32_t>(bytes, at + 4);
    elements.push_back({tag, bytes.substr(at + kAlignment, size)});
    at += kAlignment + (size + kAlignment - 1) / kAlignment * kAlignment;
  }
  return elements;
}

std::vector<double> numbers_of(const Element& element) {
  std::vector<double> numbers;
  if (element.kind == kInt32) {
    for (std::size_t at = 0; at + 4 <= element.data.size(); at += 4) {
      numbers.push_back(number_at<std::int32_t>(element.data, at));
    }
  } else if (element.kind == kDouble) {
    for (std::size_t at = 0; at + 8 <= element.data.size(); at += 8) {
      numbers.push_back(number_at<double>(element.data, at));
    }
  }
  return numbers;
}

}  // namespace

std::map<std::string, std::vector<double>> read_mat_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.size() < kHeaderBytes) {
    throw files::FileError("cannot read " + path.string());
  }
  std::map<std::string, std::vector<double>> variables;
  for (const Element& element : elements_of(std::string_view(bytes).substr(kHeaderBytes))) {
    // Flags, sizes, name, numbers.
    const auto parts = elements_of(element.data);
    if (element.kind == kMatrix && parts.size() == 4) {
      variables[std::string(parts[2].data)] = numbers_of(parts[3]);
    }
  }
  return variables;
}

}  // namespace echomap::bench
