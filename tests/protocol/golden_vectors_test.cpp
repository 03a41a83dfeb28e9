// SPDX-License-Identifier: MIT
#include "tests/support/golden_vectors.hpp"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/protocol/every_message.hpp"
#include "tests/protocol/frames.hpp"
#include "tests/support/message_description.hpp"

namespace echomap::protocol {
namespace {

using tests::GoldenFrame;
using tests::GoldenMessage;

// --- the tree against the vectors

std::vector<GoldenFrame> golden_frames_of(const std::string& message) {
  std::vector<GoldenFrame> frames;
  for (const GoldenFrame& frame : tests::load_golden_vectors().frames) {
    if (frame.message == message) {
      frames.push_back(frame);
    }
  }
  return frames;
}

struct SchemaSink {
  GoldenMessage& message;
  void operator()(const char* name, char type_code) {
    message.fields.emplace_back(name, type_code);
  }
};

struct SchemaCollector {
  std::vector<GoldenMessage> messages;
  template <class M>
  void operator()(const M* /*tag*/) {
    GoldenMessage message{M::name(), M::kId, MessageFacts<M>::kSeed, {}};
    SchemaSink sink{message};
    describe<M>(sink);
    messages.push_back(message);
  }
};

TEST(GoldenVectors, HoldTheSchemaOfEveryMessage) {
  SchemaCollector collector;
  AllMessages::for_each(collector);
  const std::vector<GoldenMessage> golden = tests::load_golden_vectors().messages;
  ASSERT_EQ(golden.size(), collector.messages.size());
  for (std::size_t i = 0; i < golden.size(); ++i) {
    const GoldenMessage& ours = collector.messages[i];
    EXPECT_EQ(golden[i].name, ours.name);
    EXPECT_EQ(golden[i].id, ours.id) << ours.name;
    EXPECT_EQ(golden[i].seed, ours.seed) << ours.name;
    EXPECT_EQ(golden[i].fields, ours.fields) << ours.name;
  }
}

TEST(GoldenVectors, PinTheSchemaDigest) {
  EXPECT_EQ(tests::load_golden_vectors().digest, kSchemaDigest);
}

template <class M>
class GoldenVectorsOf : public testing::Test {};
TYPED_TEST_SUITE(GoldenVectorsOf, TestTypes<AllMessages>::Types, MessageNames);

TYPED_TEST(GoldenVectorsOf, AreWhatTheEncoderMakes) {
  const std::vector<GoldenFrame> frames = golden_frames_of(TypeParam::name());
  EXPECT_GE(frames.size(), 2U);
  for (const GoldenFrame& frame : frames) {
    const auto message = tests::message_of<TypeParam>(frame);
    EXPECT_EQ(tests::to_hex(frame_of(message, frame.seq)), tests::to_hex(frame.bytes));
  }
}

TYPED_TEST(GoldenVectorsOf, AreTakenBackByTheDecoder) {
  for (const GoldenFrame& golden : golden_frames_of(TypeParam::name())) {
    FrameDecoder decoder(AllMessages::find_schema);
    ASSERT_THAT(outcomes(decoder, golden.bytes), testing::ElementsAre(DecodeStatus::kFrame));
    EXPECT_EQ(decoder.frame().seq, golden.seq);
    EXPECT_EQ(values_of(get_payload<TypeParam>(decoder.frame().payload)),
              values_of(tests::message_of<TypeParam>(golden)));
  }
}

// --- the vectors against a second implementation, which shares nothing with protocol/

std::uint16_t seed_by_definition(const GoldenMessage& message) {
  std::string text = message.name + '\0';
  for (const auto& [name, type_code] : message.fields) {
    text += name + '\0' + type_code;
  }
  std::uint32_t hash = 2166136261U;
  for (const char character : text) {
    hash = (hash ^ static_cast<std::uint8_t>(character)) * 16777619U;
  }
  return static_cast<std::uint16_t>(hash ^ (hash >> 16));
}

std::size_t width_of(char type_code) {
  const std::string codes = "Bb?Hh?Ii";
  return std::size_t{1} << (codes.find(type_code) / 3);
}

void append_little_endian(Bytes& bytes, std::uint64_t bits, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
  }
}

std::uint64_t bitwise_crc(const Bytes& bytes, std::uint16_t seed) {
  unsigned crc = seed;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc & 1U) != 0 ? (crc >> 1) ^ 0x8408U : crc >> 1;
    }
  }
  return crc ^ 0xFFFFU;
}

/// Splits at zeros and writes each run after its length plus one, as the paper explains it.
Bytes cobs_by_definition(const Bytes& block) {
  Bytes wire;
  Bytes run;
  const auto close_run = [&] {
    wire.push_back(static_cast<std::uint8_t>(run.size() + 1));
    wire.insert(wire.end(), run.begin(), run.end());
    run.clear();
  };
  for (const std::uint8_t byte : block) {
    if (byte == 0) {
      close_run();
    } else {
      run.push_back(byte);
    }
  }
  close_run();
  return wire;
}

Bytes frame_by_definition(const GoldenMessage& message, const GoldenFrame& frame) {
  Bytes block{message.id, frame.seq};
  for (std::size_t i = 0; i < message.fields.size(); ++i) {
    EXPECT_EQ(frame.values.at(i).first, message.fields[i].first);
    append_little_endian(block,
                         static_cast<std::uint64_t>(frame.values.at(i).second),
                         width_of(message.fields[i].second));
  }
  append_little_endian(block, bitwise_crc(block, message.seed), 2);
  Bytes wire = cobs_by_definition(block);
  wire.push_back(0);
  return wire;
}

TEST(GoldenVectors, FollowFromTheDefinitionAlone) {
  const tests::GoldenVectors vectors = tests::load_golden_vectors();
  std::size_t checked = 0;
  for (const GoldenMessage& message : vectors.messages) {
    EXPECT_EQ(message.seed, seed_by_definition(message)) << message.name;
    for (const GoldenFrame& frame : golden_frames_of(message.name)) {
      EXPECT_EQ(tests::to_hex(frame_by_definition(message, frame)), tests::to_hex(frame.bytes));
      ++checked;
    }
  }
  EXPECT_EQ(checked, vectors.frames.size());
}

// --- the reader

TEST(GoldenVectorReader, NamesTheLineItCannotRead) {
  const auto error_of = [](const std::string& text) -> std::string {
    std::istringstream stream(text);
    try {
      tests::read_golden_vectors(stream);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("# fine\n\nframes Stop"), testing::HasSubstr("line 3: neither"));
  EXPECT_THAT(error_of("message Stop 0x11 0x1 field"), testing::HasSubstr("line 1: no ':'"));
  EXPECT_THAT(error_of("digest 1\nframe Stop 1 command_id=x > 00"), testing::HasSubstr("line 2"));
}

}  // namespace
}  // namespace echomap::protocol
