// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Reads protocol/vectors/frames.txt; its head describes the format. Every reader throws
/// std::runtime_error, which names the line, when that line has another form.
namespace echomap::tests {

/// A line `message`: the schema of one message.
struct GoldenMessage {
  std::string name;
  std::uint8_t id = 0;
  std::uint16_t seed = 0;
  std::vector<std::pair<std::string, char>> fields;  ///< Name and type code, in wire order.
};

/// A line `frame`: one message as values and as bytes on the wire, delimiter included.
struct GoldenFrame {
  std::string message;
  std::uint8_t seq = 0;
  std::vector<std::pair<std::string, std::int64_t>> values;  ///< In wire order.
  std::vector<std::uint8_t> bytes;
};

/// The whole file.
struct GoldenVectors {
  std::uint32_t digest = 0;
  std::vector<GoldenMessage> messages;
  std::vector<GoldenFrame> frames;
};

/// Splits `left<mark>right`.
inline std::pair<std::string, std::string> split_at(const std::string& text, char mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) {
    throw std::runtime_error("no '" + std::string(1, mark) + "' in: " + text);
  }
  return {text.substr(0, at), text.substr(at + 1)};
}

/// Reads what follows the word `message`.
inline GoldenMessage read_golden_message(std::istringstream& words) {
  GoldenMessage message;
  std::string id;
  std::string seed;
  words >> message.name >> id >> seed;
  message.id = static_cast<std::uint8_t>(std::stoul(id, nullptr, 16));
  message.seed = static_cast<std::uint16_t>(std::stoul(seed, nullptr, 16));
  for (std::string word; words >> word;) {
    const auto [name, type_code] = split_at(word, ':');
    message.fields.emplace_back(name, type_code.at(0));
  }
  return message;
}

/// Reads what follows the word `frame`.
inline GoldenFrame read_golden_frame(std::istringstream& words) {
  GoldenFrame frame;
  int seq = 0;
  words >> frame.message >> seq;
  frame.seq = static_cast<std::uint8_t>(seq);
  for (std::string word; words >> word && word != ">";) {
    const auto [name, value] = split_at(word, '=');
    frame.values.emplace_back(name, std::stoll(value));
  }
  for (std::string word; words >> word;) {
    frame.bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
  }
  return frame;
}

/// Adds what one line says.
inline void read_golden_line(const std::string& line, GoldenVectors& vectors) {
  std::istringstream words(line);
  std::string kind;
  words >> kind;
  if (kind == "message") {
    vectors.messages.push_back(read_golden_message(words));
  } else if (kind == "frame") {
    vectors.frames.push_back(read_golden_frame(words));
  } else if (kind == "digest") {
    words >> std::setbase(0) >> vectors.digest;
  } else if (!kind.empty() && kind.front() != '#') {
    throw std::runtime_error("neither message, frame nor digest: " + kind);
  }
}

/// Reads golden vectors from text.
inline GoldenVectors read_golden_vectors(std::istream& text) {
  GoldenVectors vectors;
  int line_number = 0;
  for (std::string line; std::getline(text, line);) {
    ++line_number;
    try {
      read_golden_line(line, vectors);
    } catch (const std::exception& error) {
      throw std::runtime_error("golden vectors, line " + std::to_string(line_number) + ": " +
                               error.what());
    }
  }
  return vectors;
}

/// The golden vectors of this source tree.
inline GoldenVectors load_golden_vectors() {
  std::ifstream file(ECHOMAP_SOURCE_DIR "/protocol/vectors/frames.txt");
  if (!file) {
    throw std::runtime_error("cannot read protocol/vectors/frames.txt");
  }
  return read_golden_vectors(file);
}

/// Visitor that takes each field's value from a golden frame by name.
class GoldenValueVisitor {
 public:
  explicit GoldenValueVisitor(const GoldenFrame& frame) : frame_(frame) {}

  template <class T>
  void operator()(const char* name, T& value) const {
    for (const auto& [golden_name, golden_value] : frame_.values) {
      if (golden_name == name) {
        value = static_cast<T>(golden_value);
        return;
      }
    }
    throw std::runtime_error("golden frame of " + frame_.message + " has no field " + name);
  }

 private:
  const GoldenFrame& frame_;
};

/// The message M that a golden frame of that name holds.
template <class M>
M message_of(const GoldenFrame& frame) {
  M message{};
  const GoldenValueVisitor visitor(frame);
  M::each(message, visitor);
  return message;
}

/// Bytes as the vectors write them, for failure messages: "04 01 29 00".
inline std::string to_hex(const std::vector<std::uint8_t>& bytes) {
  std::ostringstream text;
  text << std::hex << std::uppercase << std::setfill('0');
  for (const std::uint8_t byte : bytes) {
    text << (text.tellp() > 0 ? " " : "") << std::setw(2) << static_cast<int>(byte);
  }
  return text.str();
}

}  // namespace echomap::tests
