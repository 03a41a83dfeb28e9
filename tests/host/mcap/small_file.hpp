// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/files/atomic_file.hpp"
#include "host/mcap/file_layout.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "host/mcap/records.hpp"

// What the tests of this folder write and read: files of a few messages.
namespace echomap::mcap {

inline Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

inline Bytes load_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void save_bytes(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// A record in one line.
inline std::string line_of(const Record& record) {
  if (const auto* message = std::get_if<Message>(&record)) {
    return message->channel->info.topic + " " + std::to_string(message->sequence) + " " +
           std::to_string(message->log_time_ns) + " " + std::to_string(message->publish_time_ns) +
           " " + std::string(message->data.begin(), message->data.end());
  }
  if (const auto* attachment = std::get_if<Attachment>(&record)) {
    return "attachment " + attachment->name + " " +
           std::string(attachment->data.begin(), attachment->data.end());
  }
  const auto& metadata = std::get<Metadata>(record);
  std::string line = "metadata " + metadata.name;
  for (const auto& [name, text] : metadata.entries) {
    line += " " + name + "=" + text;
  }
  return line;
}

/// All that a reader hands out of a file, and how it ends.
struct ReadOut {
  std::vector<std::string> lines;     ///< Of all records.
  std::vector<std::string> messages;  ///< Of messages alone.
  std::string error;                  ///< Empty where the file is whole.
  bool is_cut_off = false;
};

inline ReadOut read_out(const std::filesystem::path& path) {
  ReadOut out;
  try {
    McapReader reader(path);
    while (const auto record = reader.next()) {
      out.lines.push_back(line_of(*record));
      if (std::holds_alternative<Message>(*record)) {
        out.messages.push_back(out.lines.back());
      }
    }
  } catch (const CutOffFile& error) {
    out.error = error.what();
    out.is_cut_off = true;
  } catch (const files::FileError& error) {
    out.error = error.what();
  }
  return out;
}

/// Two topics, an attachment, metadata and three chunks of 2 s each.
inline void write_small_session(McapWriter& writer) {
  writer.add_metadata({"session", {{"profile", "uno_2wd"}, {"seed", "7"}}});
  const std::uint16_t schema =
      writer.add_schema({"std_msgs/msg/String", "ros2msg", "string data\n"});
  const std::uint16_t log = writer.add_channel({"/log", schema, "cdr", {{"qos", "reliable"}}});
  const std::uint16_t note = writer.add_channel({"/note", 0, "text", {}});
  constexpr std::uint64_t kSecondNs = 1'000'000'000;
  for (std::uint64_t i = 0; i < 6; ++i) {
    writer.write(log, i * kSecondNs, i * kSecondNs + 5, bytes_of("log line " + std::to_string(i)));
    if (i % 2 == 1) {
      writer.write(note, i * kSecondNs + 1, i * kSecondNs, bytes_of("note"));
    }
    if (i == 3) {
      writer.attach({7, 8, "config.toml", "text/plain", bytes_of("width_m = 4\n")});
    }
  }
}

/// Parameters under which the small session has three chunks.
inline McapWriterParams small_chunks(Compression compression = Compression::kZstd) {
  McapWriterParams params;
  params.chunk_duration_ns = 2'000'000'000;
  params.compression = compression;
  return params;
}

inline void write_small_file(const std::filesystem::path& path,
                             Compression compression = Compression::kZstd) {
  McapWriter writer({"ros2", "echomap test"}, small_chunks(compression));
  writer.open(path);
  write_small_session(writer);
  writer.finish();
}

/// The lines of the small session in the order of its file.
inline std::vector<std::string> small_session_lines() {
  return {"metadata session profile=uno_2wd seed=7",
          "/log 0 0 5 log line 0",
          "/log 1 1000000000 1000000005 log line 1",
          "/note 0 1000000001 1000000000 note",
          "attachment config.toml width_m = 4\n",
          "/log 2 2000000000 2000000005 log line 2",
          "/log 3 3000000000 3000000005 log line 3",
          "/note 1 3000000001 3000000000 note",
          "/log 4 4000000000 4000000005 log line 4",
          "/log 5 5000000000 5000000005 log line 5",
          "/note 2 5000000001 5000000000 note"};
}

}  // namespace echomap::mcap
