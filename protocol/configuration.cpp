// SPDX-License-Identifier: MIT
#include "protocol/configuration.hpp"

namespace echomap {
namespace protocol {
namespace {

struct WriteMessages {
  uint8_t* out;
  template <class M>
  void operator()(const M& message) {
    put_payload(message, out);
    out += MessageFacts<M>::kSize;
  }
};

/// Puts each id into the place of the command_id, the first field.
struct WriteIds {
  uint8_t* out;
  template <class M>
  void operator()(const M& /*message*/) {
    *out = M::kId;
    out += MessageFacts<M>::kSize;
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
  WriteIds write_ids{bytes.bytes};
  Configuration::each(configuration, write_ids);
  return bytes;
}

bool read_configuration(const ConfigurationBytes& bytes, Configuration& configuration) {
  ReadMessages read{bytes.bytes, true};
  Configuration::each(configuration, read);
  return read.ids_match;
}

}  // namespace protocol
}  // namespace echomap
