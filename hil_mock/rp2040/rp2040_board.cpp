// SPDX-License-Identifier: MIT
#include "hil_mock/rp2040/rp2040_board.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hil_mock/rp2040/pico_pins.hpp"
#include "protocol/version.hpp"

namespace echomap::rp2040 {
namespace {

using runner::Wheel;

/// Shortest trigger pulse that an HC-SR04 answers: its data sheet, "Timing diagram".
constexpr std::int64_t kMinTriggerNs = 10'000;
/// Of 12 bits; the supply of 3.3 V is the reference.
constexpr double kCountsPerMillivolt = 4096.0 / 3300.0;
constexpr double kMaxCounts = 4095.0;

std::uint8_t spare_pin(unsigned pin) {
  if (pin >= pico_pins::kSpare.size()) {
    throw std::invalid_argument("pico has no spare pin_" + std::to_string(pin));
  }
  return pico_pins::kSpare.at(pin);
}

}  // namespace

Rp2040Board::Rp2040Board(const std::filesystem::path& elf, PicoLine line)
    : program_(elf.stem().string()), chip_(elf), line_(line), host_(*this) {
  driven_levels_.fill(-1);
  host_.on_byte = [this](std::uint8_t byte) {
    if (on_sent) {
      on_sent(byte);
    }
  };
  for (const std::uint8_t pin : {pico_pins::kLeftEncoderA,
                                 pico_pins::kLeftEncoderB,
                                 pico_pins::kRightEncoderA,
                                 pico_pins::kRightEncoderB,
                                 pico_pins::kSonarEcho}) {
    drive(0, pin, false);
  }
  set_bump(Wheel::kLeft, false);
  set_bump(Wheel::kRight, false);
  if (line_ == PicoLine::kUsb) {
    host_.plug(true, 0);
  }
  exchange();
}

std::int64_t Rp2040Board::now_ns() const { return std::min(chip_ns_, until_ns_); }

void Rp2040Board::run_until(std::int64_t until_ns) {
  until_ns_ = std::max(until_ns_, until_ns);
  while (chip_ns_ < until_ns_) {
    const bool has_host = line_ == PicoLine::kUsb;
    const bool polls = has_host && host_.only_polls() && host_due_ns_ > chip_ns_;
    const std::int64_t stop_ns = has_host && !polls ? std::min(until_ns_, host_due_ns_) : until_ns_;
    if (stop_ns > chip_ns_) {
      orders_.byte('G').number(static_cast<double>(stop_ns));
      orders_.byte(has_host && host_.is_open() ? 1 : 0);
      orders_.number(polls ? static_cast<double>(host_due_ns_) : 0.0);
      exchange();
      host_due_ns_ = polls ? poll_ns_ : host_due_ns_;
    }
    if (has_host && (chip_ns_ >= host_due_ns_ || chip_ns_ < stop_ns)) {
      host_due_ns_ = host_.service(chip_ns_);
    }
  }
}

void Rp2040Board::reset(ResetCause cause) {
  orders_.byte('R').byte(static_cast<std::uint8_t>(cause));
  exchange();
}

void Rp2040Board::receive(std::span<const std::uint8_t> bytes) {
  if (line_ == PicoLine::kUsb) {
    host_.send(bytes);
    host_due_ns_ = std::min(host_due_ns_, chip_ns_);
  } else {
    orders_.byte('B').block(bytes);
  }
}

void Rp2040Board::plug_line(bool in) {
  if (line_ == PicoLine::kUsb) {
    host_.plug(in, chip_ns_);
  }
}

void Rp2040Board::schedule_encoder_edge(Wheel wheel, std::int64_t at_ns, bool a, bool b) {
  const bool left = wheel == Wheel::kLeft;
  drive(at_ns, left ? pico_pins::kLeftEncoderA : pico_pins::kRightEncoderA, a);
  drive(at_ns, left ? pico_pins::kLeftEncoderB : pico_pins::kRightEncoderB, b);
}

void Rp2040Board::schedule_echo(std::int64_t rise_ns, std::int64_t fall_ns) {
  orders_.byte('L').number(static_cast<double>(rise_ns)).byte(pico_pins::kSonarEcho).byte(1);
  orders_.byte('L').number(static_cast<double>(fall_ns)).byte(pico_pins::kSonarEcho).byte(0);
}

void Rp2040Board::set_bump(Wheel side, bool pressed) {
  drive(chip_ns_, side == Wheel::kLeft ? pico_pins::kLeftBump : pico_pins::kRightBump, !pressed);
}

void Rp2040Board::set_aux_level(unsigned pin, bool high) { drive(chip_ns_, spare_pin(pin), high); }

void Rp2040Board::schedule_aux_pulse(unsigned pin, std::int64_t fall_ns, std::int64_t rise_ns) {
  drive(fall_ns, spare_pin(pin), false);
  drive(rise_ns, spare_pin(pin), true);
}

void Rp2040Board::set_aux_millivolts(unsigned pin, double millivolts) {
  const unsigned channel = pin - pico_pins::kFirstAnalogSpare;
  if (pin < pico_pins::kFirstAnalogSpare || channel >= pico_pins::kAnalogSpares) {
    throw std::invalid_argument("pico's pin_" + std::to_string(pin) + " reads no voltage");
  }
  const double counts = std::clamp(millivolts * kCountsPerMillivolt, 0.0, kMaxCounts);
  orders_.byte('A').byte(static_cast<std::uint8_t>(channel));
  orders_.half_word(static_cast<std::uint16_t>(counts));
}

bool Rp2040Board::aux_output(unsigned pin) const { return signals_.drives_high(spare_pin(pin)); }

void Rp2040Board::connect(world::TwoWireDevice& device) {
  devices_.push_back(&device);
  orders_.byte('D').byte(device.address());
}

std::string Rp2040Board::firmware_name() const {
  return program_ + ' ' + protocol::VersionText(protocol::kFirmwareVersion).text();
}

std::uint32_t Rp2040Board::peek(std::uint32_t address) {
  orders_.byte('k').word(address);
  exchange();
  return peeked_;
}

void Rp2040Board::poke(std::uint32_t address, std::uint32_t value) {
  orders_.byte('K').word(address).word(value);
  exchange();
}

void Rp2040Board::jump(std::uint32_t address) {
  orders_.byte('J').word(address);
  exchange();
}

void Rp2040Board::meter_load() {
  orders_.byte('M');
  exchange();
}

Rp2040Board::Load Rp2040Board::load() {
  orders_.byte('m');
  exchange();
  return load_;
}

void Rp2040Board::hold_two_wire_bus(unsigned bits) {
  orders_.byte('H').byte(static_cast<std::uint8_t>(bits));
  exchange();
}

void Rp2040Board::plug(bool plugged) { orders_.byte('V').byte(plugged ? 1 : 0); }

void Rp2040Board::reset_bus() { transact('R', 0, 0, false, {}); }

void Rp2040Board::suspend_bus() { transact('P', 0, 0, false, {}); }

void Rp2040Board::resume_bus(UsbResume resume) {
  transact('W', 0, 0, resume == UsbResume::kNoticed, {});
}

UsbAnswer Rp2040Board::setup(std::uint8_t address, std::span<const std::uint8_t> packet) {
  return transact('S', address, 0, false, packet).answer;
}

UsbData Rp2040Board::in(std::uint8_t address, std::uint8_t endpoint) {
  return transact('I', address, endpoint, false, {});
}

UsbAnswer Rp2040Board::out(std::uint8_t address,
                           std::uint8_t endpoint,
                           bool data1,
                           std::span<const std::uint8_t> bytes) {
  return transact('O', address, endpoint, data1, bytes).answer;
}

UsbData Rp2040Board::transact(char kind,
                              std::uint8_t address,
                              std::uint8_t endpoint,
                              bool data1,
                              std::span<const std::uint8_t> bytes) {
  orders_.byte('U').byte(static_cast<std::uint8_t>(kind)).byte(address).byte(endpoint);
  orders_.byte(data1 ? 1 : 0).block(bytes);
  exchange();
  return usb_data_;
}

void Rp2040Board::drive(std::int64_t at_ns, std::uint8_t pin, bool level) {
  std::int8_t& last = driven_levels_.at(pin);
  if (last != static_cast<std::int8_t>(level)) {
    last = static_cast<std::int8_t>(level);
    orders_.byte('L').number(static_cast<double>(at_ns)).byte(pin).byte(level ? 1 : 0);
  }
}

void Rp2040Board::exchange() {
  chip_.send(orders_);
  orders_.clear();
  for (bool ended = false; !ended;) {
    Message events = chip_.receive();
    while (!events.is_at_end()) {
      ended = replay(events);
    }
  }
}

/// Takes the first of these events; whether it was the end of the answer.
bool Rp2040Board::replay(Message& events) {
  const std::uint8_t kind = events.take_byte();
  chip_ns_ = std::llround(events.take_number());
  switch (kind) {
    case 'P':
      replay_pins(events);
      return false;
    case 'S': {
      const std::uint8_t byte = events.take_byte();
      if (on_sent && line_ == PicoLine::kUart) {
        on_sent(byte);
      }
      return false;
    }
    case 'r':
    case 'w':
      answer_register(events, kind == 'r');
      return false;
    case 'U':
      usb_data_.answer = static_cast<UsbAnswer>(events.take_byte());
      usb_data_.data1 = events.take_byte() != 0;
      usb_data_.bytes = events.take_block();
      return false;
    case 'k':
      peeked_ = events.take_word();
      return false;
    case 'm':
      load_.busy_share = events.take_number();
      load_.tick_jitter_us = events.take_number() * 1e-3;
      return false;
    default:
      resets_ = events.take_word();
      attached_ = events.take_byte() != 0;
      has_bulk_in_ = events.take_byte() != 0;
      poll_ns_ = std::llround(events.take_number());
      return true;
  }
}

void Rp2040Board::replay_pins(Message& events) {
  const bool was_high = signals_.trigger_is_high();
  signals_.take(events);
  const bool is_high = signals_.trigger_is_high();
  if (is_high && !was_high) {
    trigger_rise_ns_ = chip_ns_;
  } else if (was_high && !is_high && chip_ns_ - trigger_rise_ns_ >= kMinTriggerNs && on_trigger) {
    on_trigger(now_ns());
  }
  if (on_duty) {
    on_duty();
  }
}

void Rp2040Board::answer_register(Message& events, bool reads) {
  const std::uint8_t address = events.take_byte();
  const std::uint8_t device_register = events.take_byte();
  const std::uint8_t value = events.take_byte();
  Message answer;
  for (world::TwoWireDevice* const device : devices_) {
    if (device->address() == address) {
      if (reads) {
        answer.byte(device->read(device_register));
      } else {
        device->write(device_register, value);
        answer.byte(0);
      }
      break;
    }
  }
  chip_.send(answer);
}

}  // namespace echomap::rp2040
