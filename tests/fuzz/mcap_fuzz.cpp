// SPDX-License-Identifier: MIT
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>
#include <variant>

#include "host/files/atomic_file.hpp"
#include "host/mcap/chunk_compression.hpp"
#include "host/mcap/mcap_reader.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "host/mcap/record_encoding.hpp"
#include "host/mcap/record_writer.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"

namespace {

using echomap::fuzz::Input;
using echomap::fuzz::require;
namespace mcap = echomap::mcap;

/// A session of two chunks, with an attachment and metadata.
Input session_in(mcap::Compression compression) {
  const echomap::fuzz::MemoryFile file;
  mcap::McapWriterParams params;
  params.chunk_bytes = 100;
  params.compression = compression;
  mcap::McapWriter writer({"ros2", "fuzz"}, params);
  writer.open(file.path());
  const std::uint16_t schema = writer.add_schema({"String", "ros2msg", "string data"});
  const std::uint16_t log = writer.add_channel({"/log", schema, "cdr", {{"a", "b"}}});
  const Input payload = echomap::fuzz::input_of("a line of the log");
  for (std::uint64_t i = 0; i < 4; ++i) {
    writer.write(log, i, i, payload);
  }
  writer.attach({1, 2, "file", "text/plain", payload});
  writer.add_metadata({"set", {{"name", "text"}}});
  writer.finish();
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The same records without any checksum, so that damage gets past the first look: some loose, some
/// in a chunk.
Input session_without_checksums(mcap::Compression compression) {
  mcap::Bytes records;
  mcap::append_schema(records, 1, {"String", "ros2msg", "string data"});
  mcap::append_channel(records, 2, {"/log", 1, "cdr", {{"a", "b"}}});
  const Input payload = echomap::fuzz::input_of("a line of the log");
  mcap::append_message(records, {2, 0, 5, 6, payload});
  Input file(mcap::kMagic.begin(), mcap::kMagic.end());
  mcap::append_header(file, {"ros2", "fuzz"});
  file.insert(file.end(), records.begin(), records.end());
  const mcap::Bytes stored = mcap::compress(records, compression, 1);
  {
    mcap::RecordWriter chunk(file, mcap::Opcode::kChunk);
    chunk.number(std::uint64_t{5});
    chunk.number(std::uint64_t{5});
    chunk.number(std::uint64_t{records.size()});
    chunk.number(std::uint32_t{0});
    chunk.text(mcap::name_of(compression));
    chunk.number(std::uint64_t{stored.size()});
    chunk.bytes(stored);
  }
  mcap::append_metadata(file, {"set", {{"name", "text"}}});
  mcap::append_data_end(file, 0);
  return file;
}

void read_all(mcap::McapReader& reader) {
  while (const auto record = reader.next()) {
    if (const auto* message = std::get_if<mcap::Message>(&*record)) {
      require(message->channel != nullptr, "a message has a channel");
      require((message->channel->schema != nullptr) == (message->channel->info.schema_id != 0),
              "a channel has the schema that it names");
    }
    require(reader.progress() > 0.0 && reader.progress() <= 1.0, "progress is a share");
  }
  require(!reader.next(), "behind the end is nothing");
}

/// Reads on where the file was refused before.
void read_again(mcap::McapReader& reader, std::string_view reason) {
  try {
    reader.next();
  } catch (const echomap::files::FileError& error) {
    require(reason == error.what(), "a failure stays the same");
    return;
  }
  require(false, "a failure stays one");
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {session_in(mcap::Compression::kNone),
          session_in(mcap::Compression::kZstd),
          session_in(mcap::Compression::kLz4),
          session_without_checksums(mcap::Compression::kNone),
          session_without_checksums(mcap::Compression::kZstd),
          session_without_checksums(mcap::Compression::kLz4)};
}

/// One input is an MCAP file. It is read, or refused with a FileError that stays the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static echomap::fuzz::MemoryFile file;
  file.write({data, size});
  try {
    mcap::McapReader reader(file.path());
    try {
      read_all(reader);
    } catch (const echomap::files::FileError& error) {
      require(std::string_view(error.what()).size() < 1000, "an error can be read");
      read_again(reader, error.what());
    }
  } catch (const echomap::files::FileError&) {
  }
  return 0;
}
