// SPDX-License-Identifier: MIT
#include "protocol/configuration.hpp"

namespace echomap {
namespace protocol {
namespace {

/// Writes message after message; the id takes the place of the command_id, their first field.
struct WriteMessages {
  uint8_t* out;
  template <class M>
  void operator()(const M& message) {
    const Payload<M> payload(message);
    write(M::kId, payload.bytes(), MessageFacts<M>::kSize);
  }
  void write(uint8_t id, const uint8_t* payload, uint8_t size) {
    memcpy(out, payload, size);
    *out = id;
    out += size;
  }
};

struct ReadMessages {
  const uint8_t* in;
  bool ids_match;
  template <class M>
  void operator()(M& message) {
    ids_match = ids_match && *in == M::kId;
    message = get_payload<M>(in);
    message.command_id = 0;
    in += MessageFacts<M>::kSize;
  }
};

}  // namespace

ConfigurationBytes configuration_bytes(const Configuration& configuration) {
  ConfigurationBytes bytes;
  WriteMessages write{bytes.bytes};
  Configuration::each(configuration, write);
  return bytes;
}

bool read_configuration(const ConfigurationBytes& bytes, Configuration& configuration) {
  ReadMessages read{bytes.bytes, true};
  Configuration::each(configuration, read);
  return read.ids_match;
}

}  // namespace protocol
}  // namespace echomap
