// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/cortex_core.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kVectorTable = 0x08000000;
constexpr std::uint32_t kThumb = 1;
constexpr std::uint32_t kNowhere = 0xFFFFFFFE;
constexpr std::uint32_t kPsrThumb = 1U << 24;
constexpr std::uint32_t kReturnToThread = 0xFFFFFFF9;
constexpr std::uint32_t kReturnToHandler = 0xFFFFFFF1;
constexpr std::uint32_t kPsrException = 0x1FF;
/// Unicorn's number of the event that a branch to an EXC_RETURN value makes.
constexpr std::uint32_t kExceptionReturn = 8;
/// ARM Cortex-M3 technical reference manual: entry and return without wait states.
constexpr std::uint64_t kEntryCycles = 12;
constexpr std::uint64_t kReturnCycles = 12;

/// What is pushed on exception entry, from the lowest address: ARM DDI 0403, B1.5.6.
constexpr std::array<int, 8> kFrame{UC_ARM_REG_R0,
                                    UC_ARM_REG_R1,
                                    UC_ARM_REG_R2,
                                    UC_ARM_REG_R3,
                                    UC_ARM_REG_R12,
                                    UC_ARM_REG_LR,
                                    UC_ARM_REG_PC,
                                    UC_ARM_REG_XPSR};
constexpr std::uint32_t kFrameBytes = 4 * kFrame.size();

void check(uc_err error) {
  if (error != UC_ERR_OK) {
    throw std::runtime_error(std::string("Unicorn: ") + uc_strerror(error));
  }
}

std::string hex(std::uint32_t value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "0x%08X", value);
  return text.data();
}

uc_engine* open_cortex_m3() {
  uc_engine* engine = nullptr;
  check(uc_open(UC_ARCH_ARM, static_cast<uc_mode>(UC_MODE_THUMB | UC_MODE_MCLASS), &engine));
  check(uc_ctl_set_cpu_model(engine, UC_CPU_ARM_CORTEX_M3));
  return engine;
}

/// Unicorn takes hooks of every kind as an untyped pointer.
template <class Function>
void* hook_of(Function* function) {
  return reinterpret_cast<void*>(function);
}

}  // namespace

CortexCore::CortexCore(EventQueue& queue, Nvic& nvic)
    : queue_(queue), nvic_(nvic), engine_(open_cortex_m3()) {
  uc_hook hook = 0;
  check(uc_hook_add(engine_.get(), &hook, UC_HOOK_BLOCK, hook_of(&on_block), this, 1, 0));
  check(uc_hook_add(engine_.get(), &hook, UC_HOOK_INTR, hook_of(&on_exception), this, 1, 0));
}

void CortexCore::map_rom(std::uint32_t address, std::uint32_t bytes) {
  check(uc_mem_map(engine_.get(), address, bytes, UC_PROT_READ | UC_PROT_EXEC));
}

void CortexCore::map_ram(std::uint32_t address, std::uint32_t bytes) {
  check(uc_mem_map(engine_.get(), address, bytes, UC_PROT_READ | UC_PROT_WRITE));
}

void CortexCore::map_device(std::uint32_t address, std::uint32_t bytes, Device& device) {
  device.base = address;
  const auto read = [](uc_engine*, std::uint64_t offset, unsigned size, void* data) {
    auto& self = *static_cast<Device*>(data);
    return std::uint64_t{self.read(self.base + static_cast<std::uint32_t>(offset), size)};
  };
  const auto write =
      [](uc_engine*, std::uint64_t offset, unsigned size, std::uint64_t value, void* data) {
        auto& self = *static_cast<Device*>(data);
        self.write(self.base + static_cast<std::uint32_t>(offset),
                   size,
                   static_cast<std::uint32_t>(value));
      };
  check(uc_mmio_map(engine_.get(), address, bytes, read, &device, write, &device));
}

void CortexCore::write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  check(uc_mem_write(engine_.get(), address, bytes.data(), bytes.size()));
}

void CortexCore::reset() {
  std::array<std::uint32_t, 2> vectors{};
  check(uc_mem_read(engine_.get(), kVectorTable, vectors.data(), sizeof(vectors)));
  set(UC_ARM_REG_PRIMASK, 0);
  set(UC_ARM_REG_BASEPRI, 0);
  set(UC_ARM_REG_XPSR, kPsrThumb);
  set(UC_ARM_REG_SP, vectors[0]);
  set(UC_ARM_REG_PC, vectors[1]);
  sleeping_ = false;
}

void CortexCore::run_to(std::uint64_t cycle) {
  interrupted_ = false;
  until_ = cycle;
  while (queue_.now() < cycle && !interrupted_) {
    queue_.call_due();
    if (interrupted_) {
      return;
    }
    sleeping_ = sleeping_ && !nvic_.wakes(masks().basepri);
    if (sleeping_) {
      sleep();
    } else if (!serve_exception()) {
      execute();
    }
  }
}

std::uint32_t CortexCore::program_counter() const { return get(UC_ARM_REG_PC); }

void CortexCore::jump_to(std::uint32_t address) {
  set(UC_ARM_REG_PC, address | kThumb);
  sleeping_ = false;
}

/// Called before each block of code; a stop here is one before the block.
void CortexCore::on_block(uc_engine* engine,
                          std::uint64_t /*address*/,
                          std::uint32_t size,
                          void* core) {
  auto& self = *static_cast<CortexCore*>(core);
  if (self.must_stop()) {
    self.stopped_ = true;
    uc_emu_stop(engine);
    return;
  }
  self.queue_.spend(std::uint64_t{self.half_word_cycles_} * (size / 2));
}

void CortexCore::on_exception(uc_engine* engine, std::uint32_t number, void* core) {
  auto& self = *static_cast<CortexCore*>(core);
  self.stopped_ = true;
  if (number == kExceptionReturn) {
    self.returning_ = true;
  } else {
    self.fault_ = static_cast<int>(number);
  }
  uc_emu_stop(engine);
}

std::uint32_t CortexCore::get(int name) const {
  std::uint32_t value = 0;
  check(uc_reg_read(engine_.get(), name, &value));
  return value;
}

void CortexCore::set(int name, std::uint32_t value) {
  check(uc_reg_write(engine_.get(), name, &value));
}

Nvic::Masks CortexCore::masks() const {
  return {get(UC_ARM_REG_PRIMASK) != 0, static_cast<std::uint8_t>(get(UC_ARM_REG_BASEPRI))};
}

bool CortexCore::must_stop() const {
  return interrupted_ || queue_.now() >= until_ || queue_.now() >= queue_.next() ||
         (nvic_.has_pending() && nvic_.next(masks()));
}

bool CortexCore::serve_exception() {
  if (!nvic_.has_pending()) {
    return false;
  }
  const auto exception = nvic_.next(masks());
  if (exception) {
    enter(*exception);
  }
  return exception.has_value();
}

void CortexCore::enter(Exception exception) {
  std::array<std::uint32_t, kFrame.size()> frame{};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    frame[i] = get(kFrame[i]);
  }
  const bool from_handler = (frame.back() & kPsrException) != 0;
  const std::uint32_t stack = get(UC_ARM_REG_SP) - kFrameBytes;
  check(uc_mem_write(engine_.get(), stack, frame.data(), kFrameBytes));
  std::uint32_t handler = 0;
  check(uc_mem_read(engine_.get(), kVectorTable + 4U * exception, &handler, sizeof(handler)));
  set(UC_ARM_REG_SP, stack);
  set(UC_ARM_REG_LR, from_handler ? kReturnToHandler : kReturnToThread);
  set(UC_ARM_REG_XPSR, kPsrThumb | exception);
  set(UC_ARM_REG_PC, handler);
  nvic_.enter(exception);
  queue_.spend(kEntryCycles);
  if (on_enter) {
    on_enter(exception);
  }
}

void CortexCore::leave() {
  std::array<std::uint32_t, kFrame.size()> frame{};
  const std::uint32_t stack = get(UC_ARM_REG_SP);
  check(uc_mem_read(engine_.get(), stack, frame.data(), kFrameBytes));
  set(UC_ARM_REG_SP, stack + kFrameBytes);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    set(kFrame[i], kFrame[i] == UC_ARM_REG_PC ? frame[i] | kThumb : frame[i]);
  }
  nvic_.leave();
  queue_.spend(kReturnCycles);
}

void CortexCore::sleep() {
  const std::uint64_t begin = queue_.now();
  queue_.skip_to(std::min(until_, queue_.next()));
  slept_cycles_ += queue_.now() - begin;
}

/// Runs blocks until one of the hooks, or WFI, stops it.
void CortexCore::execute() {
  stopped_ = false;
  const uc_err error = uc_emu_start(engine_.get(), program_counter() | kThumb, kNowhere, 0, 0);
  if (error != UC_ERR_OK) {
    crash(uc_strerror(error));
  }
  if (fault_ != 0) {
    crash("exception " + std::to_string(fault_));
  }
  sleeping_ = !stopped_;
  if (returning_) {
    returning_ = false;
    leave();
  }
}

void CortexCore::crash(const std::string& why) const {
  throw std::runtime_error("the emulated program has crashed at " + hex(program_counter()) + ": " +
                           why);
}

}  // namespace echomap::unicorn
