// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/register_hooks.hpp"

#include <sim_io.h>
#include <utility>

namespace echomap::emulator {

void RegisterHooks::after_write(std::uint16_t address, std::function<void()> hook) {
  auto& slot = avr_.io[AVR_DATA_TO_IO(address)].w;
  after_writes_.push_back({slot.c, slot.param, std::move(hook)});
  slot.param = &after_writes_.back();
  slot.c = [](avr_t* avr, avr_io_addr_t addr, std::uint8_t value, void* param) {
    const auto& self = *static_cast<AfterWrite*>(param);
    if (self.inner != nullptr) {
      self.inner(avr, addr, value, self.inner_param);
    } else {
      avr->data[addr] = value;
    }
    self.hook();
  };
}

void RegisterHooks::replace_write(std::uint16_t address, std::function<void(std::uint8_t)> hook) {
  auto& slot = avr_.io[AVR_DATA_TO_IO(address)].w;
  writes_.push_back(std::move(hook));
  slot.param = &writes_.back();
  slot.c = [](avr_t*, avr_io_addr_t, std::uint8_t value, void* param) {
    (*static_cast<std::function<void(std::uint8_t)>*>(param))(value);
  };
}

void RegisterHooks::replace_read(std::uint16_t address, std::function<std::uint8_t()> hook) {
  auto& slot = avr_.io[AVR_DATA_TO_IO(address)].r;
  reads_.push_back(std::move(hook));
  slot.param = &reads_.back();
  slot.c = [](avr_t*, avr_io_addr_t, void* param) -> std::uint8_t {
    return (*static_cast<std::function<std::uint8_t()>*>(param))();
  };
}

}  // namespace echomap::emulator
