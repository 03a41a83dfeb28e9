// SPDX-License-Identifier: MIT
#include "firmware/drivers/serial_port.hpp"
#include "firmware/hal/board.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

/// A board that decodes every whole frame it receives, encodes the message again with the same
/// sequence number and sends it back: the golden vectors, run by the AVR itself.
namespace echomap {

drivers::SerialPort port;
protocol::FrameEncoder encoder;

namespace hal {

void on_tick() {}
void on_echo_edge(bool /*high*/, uint32_t /*stamp_half_us*/) {}
void on_byte_received(uint8_t byte) { port.on_received(byte); }
void on_receive_overrun() { port.on_overrun(); }
bool next_byte_to_send(uint8_t& byte) { return port.on_send_ready(byte); }

}  // namespace hal

namespace {

struct SendBack {
  uint8_t seq;

  template <class M>
  void operator()(const M& message) {
    const protocol::ByteSpan frame = encoder.encode(message, seq);
    while (!port.send(frame)) {
    }
  }
};

}  // namespace
}  // namespace echomap

int main() {
  using namespace echomap;
  hal::start_board();
  hal::enable_interrupts();
  protocol::FrameDecoder decoder(protocol::AllMessages::find_schema);
  for (;;) {
    uint8_t byte = 0;
    if (!port.receive(byte) || decoder.take(byte) != protocol::DecodeStatus::kFrame) {
      continue;
    }
    const protocol::Frame frame = decoder.frame();
    SendBack send_back{frame.seq};
    protocol::Dispatcher<protocol::AllMessages>::dispatch(frame.id, frame.payload, send_back);
  }
}
