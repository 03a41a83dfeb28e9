// SPDX-License-Identifier: MIT
/// The program in an ATmega: takes its request from the serial port, and reports there.
#include <avr/io.h>

#include "tests/firmware/differential/program.hpp"

namespace echomap {
namespace differential {
namespace {

uint32_t read_number() {
  uint32_t number = 0;
  for (uint8_t bits = 0; bits < 32; bits = static_cast<uint8_t>(bits + 8)) {
    while ((UCSR0A & _BV(RXC0)) == 0) {
    }
    number |= uint32_t{UDR0} << bits;
  }
  return number;
}

void write_number(uint32_t number) {
  for (uint8_t bytes = 4; bytes != 0; --bytes) {
    while ((UCSR0A & _BV(UDRE0)) == 0) {
    }
    UDR0 = static_cast<uint8_t>(number);
    number >>= 8;
  }
}

}  // namespace

void report(const Report& report) {
  write_number(report.step);
  write_number(report.sum);
  write_number(report.sum_of_sums);
}

}  // namespace differential
}  // namespace echomap

int main() {
  using namespace echomap::differential;
  UCSR0A = _BV(U2X0);
  UBRR0 = 15;  // 125 kBd.
  UCSR0B = _BV(RXEN0) | _BV(TXEN0);
  Request request{};
  request.seed = read_number();
  request.steps = read_number();
  request.report_every = read_number();
  request.report_from = read_number();
  run(request);
  for (;;) {
  }
}
