// SPDX-License-Identifier: MIT
/// Asks an emulated chip, by the probe program, what its data sheet says a real one does.
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil_mock/emulator/chip_modules.hpp"
#include "hil_mock/emulator/simavr_board.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/hil/probe/probe_commands.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/simulated_time.hpp"
#include "tests/support/small_elf.hpp"

namespace echomap::emulator {
namespace {

using runner::Wheel;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tests::kMs;

constexpr std::uint8_t kPorf = 1;
constexpr std::uint8_t kExtrf = 2;
constexpr std::uint8_t kWdrf = 8;
constexpr std::uint8_t kAllTimer0Flags = 7;
/// (16 + 1) x 8 samples x 10 bits: 115200 baud with U2X0.
constexpr std::uint64_t kByteCycles = 1360;

struct SentByte {
  std::uint8_t value;
  std::uint64_t cycle;
};

std::string probe_of(const std::string& chip) { return ECHOMAP_PROBE + chip + ".elf"; }

class EmulatedChip : public ::testing::TestWithParam<const char*> {
 protected:
  EmulatedChip() {
    board.on_sent = [this](std::uint8_t byte) { sent.push_back({byte, board.machine().cycle()}); };
    run_ms(5);
  }

  void run_ms(std::int64_t ms) { board.run_until(board.now_ns() + ms * kMs); }

  void ask(ProbeCommand command) {
    sent.clear();
    const std::uint8_t byte = command;
    board.receive(std::span(&byte, 1));
  }

  /// The answer to `command` in `ms` milliseconds.
  std::vector<std::uint8_t> answer_to(ProbeCommand command, std::int64_t ms) {
    ask(command);
    run_ms(ms);
    return answer();
  }

  std::vector<std::uint8_t> answer() const {
    std::vector<std::uint8_t> values;
    values.reserve(sent.size());
    for (const SentByte& byte : sent) {
      values.push_back(byte.value);
    }
    return values;
  }

  /// The bit in PINx.
  bool level(Pin pin) {
    const std::uint8_t levels =
        board.machine().data_at(find_port(board.machine().core(), pin.port).r_pin);
    return ((levels >> pin.bit) & 1) != 0;
  }

  SimavrBoard board{probe_of(GetParam())};
  const BoardWiring& wiring = wiring_of_chip(GetParam());
  std::vector<SentByte> sent;
};

INSTANTIATE_TEST_SUITE_P(Chips,
                         EmulatedChip,
                         ::testing::Values("atmega328p", "atmega2560"),
                         [](const auto& chip) { return std::string(chip.param); });

TEST_P(EmulatedChip, PowerOnIsTheFirstResetCause) {
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0].value, kPorf);
}

TEST_P(EmulatedChip, SendsOneByteInTenBitTimes) {
  ASSERT_EQ(answer_to(kProbeSendBurst, 20).size(), 100U);
  for (std::size_t i = 1; i < sent.size(); ++i) {
    EXPECT_NEAR(double(sent[i].cycle - sent[i - 1].cycle), kByteCycles, 4) << i;
  }
  EXPECT_NEAR(double(sent[99].cycle - sent[0].cycle), 99 * kByteCycles, 20);
}

TEST_P(EmulatedChip, DeafReceiverKeepsThreeBytesAndReportsTheOverrun) {
  ask(kProbeOverrunReceiver);
  const std::vector<std::uint8_t> more(10, 0x55);
  board.receive(more);
  run_ms(30);
  EXPECT_THAT(answer(), ElementsAre(3, 1));
}

TEST_P(EmulatedChip, ReceivesThreeBytesWithoutOverrun) {
  ask(kProbeOverrunReceiver);
  const std::vector<std::uint8_t> more(3, 0x55);
  board.receive(more);
  run_ms(30);
  EXPECT_THAT(answer(), ElementsAre(3, 0));
}

TEST_P(EmulatedChip, ClearsOnlyTheTimerFlagsWrittenAsOne) {
  EXPECT_THAT(answer_to(kProbeClearOneFlag, 5), ElementsAre(kAllTimer0Flags, 5, 0));
}

TEST_P(EmulatedChip, FlagOlderThanItsEnablingFiresOnce) {
  EXPECT_THAT(answer_to(kProbeEnableAfterFlag, 5), ElementsAre(1));
}

TEST_P(EmulatedChip, InterruptEntryTakesTime) {
  const std::vector<std::uint8_t> count = answer_to(kProbeTimeInterruptEntry, 5);
  ASSERT_EQ(count.size(), 2U);
  // 4 to enter, 5 where the program counter has three bytes; 3 for the vector's jmp, 2 for push, up
  // to 2 of the instruction under way, 1 or 2 until the match is seen.
  const int latency = count[0] + 256 * count[1] - 1000;
  const int entry = GetParam() == std::string("atmega2560") ? 5 : 4;
  EXPECT_GE(latency, entry + 5);
  EXPECT_LE(latency, entry + 9);
}

TEST_P(EmulatedChip, PortWriteLeavesAPulledUpInputAsDriven) {
  EXPECT_THAT(answer_to(kProbeWritePortWithPullUp, 5), ElementsAre(0, 0));
}

TEST_P(EmulatedChip, WatchdogResetsKeepsRamAndSaysSo) {
  EXPECT_THAT(answer_to(kProbeWaitForWatchdog, 40), ElementsAre(kWdrf, 77));
  EXPECT_EQ(board.machine().resets(), 1U);
  EXPECT_GT(board.machine().core().run_cycle_limit, 1U) << "the emulator is slow from here on";
}

TEST_P(EmulatedChip, SerialLineWorksAfterAWatchdogReset) {
  answer_to(kProbeWaitForWatchdog, 40);
  EXPECT_EQ(answer_to(kProbeSendBurst, 20).size(), 100U);
}

TEST_P(EmulatedChip, ExternalResetKeepsRamPowerOnDoesNot) {
  answer_to(kProbeWaitForWatchdog, 40);
  sent.clear();
  board.machine().reset(ResetSource::kExternal);
  run_ms(5);
  EXPECT_THAT(answer(), ElementsAre(kExtrf, 77));
  sent.clear();
  board.machine().reset(ResetSource::kPowerOn);
  run_ms(5);
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0].value, kPorf);
  EXPECT_NE(sent[1].value, 77);
}

TEST_P(EmulatedChip, PinsKeepTheirLevelsThroughAReset) {
  board.set_bump(Wheel::kLeft, true);
  board.machine().reset(ResetSource::kExternal);
  run_ms(5);
  EXPECT_FALSE(level(wiring.left_bump));
  EXPECT_TRUE(level(wiring.right_bump));
}

TEST_P(EmulatedChip, SleepsExactlyAsLongAsTheTicksLast) {
  EXPECT_THAT(answer_to(kProbeSleep100Ticks, 120), ElementsAre('z'));
  constexpr double kBootCycles = 5 * 16'000;
  const double slept_cycles = double(sent[0].cycle) - kBootCycles - 2.0 * kByteCycles;
  EXPECT_NEAR(slept_cycles, 100 * 16'000, 200);
}

TEST_P(EmulatedChip, CapturesAnEchoToHalfAMicrosecond) {
  for (const std::int64_t width_us : {150, 1000, 5831, 23'500}) {
    ASSERT_THAT(answer_to(kProbeCaptureEcho, 1), ElementsAre('c'));
    sent.clear();
    const std::int64_t rise_ns = board.now_ns() + 460'300;
    board.schedule_echo(rise_ns, rise_ns + width_us * 1000);
    run_ms(30);
    ASSERT_EQ(sent.size(), 2U);
    const double measured_us = 0.5 * (sent[0].value + 256 * sent[1].value);
    EXPECT_NEAR(measured_us, double(width_us % 20'000), 0.51);
  }
}

TEST_P(EmulatedChip, ServoPulseIsThatOfTimer1) {
  EXPECT_EQ(board.pan_pulse_us(), 0.0);
  answer_to(kProbeCaptureEcho, 5);
  EXPECT_EQ(board.pan_pulse_us(), 1500.0);
}

TEST_P(EmulatedChip, OnlyALongEnoughTriggerPulseCounts) {
  std::vector<std::int64_t> triggers;
  board.on_trigger = [&](std::int64_t at_ns) { triggers.push_back(at_ns); };
  const std::int64_t start_ns = board.now_ns();
  EXPECT_THAT(answer_to(kProbePulseTriggers, 5), ElementsAre('t'));
  ASSERT_EQ(triggers.size(), 1U);
  const double command_us = 85.0;
  EXPECT_NEAR(double(triggers[0] - start_ns) / 1000, command_us + 5 + 50 + 11, 4);
}

TEST_P(EmulatedChip, MotorDutyIsLevelAndDirection) {
  EXPECT_EQ(board.motor_duty().left, 0.0);
  EXPECT_EQ(board.motor_duty().right, 0.0);
  answer_to(kProbeDriveMotors, 2);
  EXPECT_EQ(board.motor_duty().left, 0.75);
  EXPECT_EQ(board.motor_duty().right, -0.25);
}

TEST_P(EmulatedChip, AMotorHasNoLevelFromAPinThatIsNoOutput) {
  answer_to(kProbeDriveMotors, 2);
  EXPECT_THAT(answer_to(kProbeReleaseForward, 2), ElementsAre('r'));
  EXPECT_EQ(board.motor_duty().left, -0.75) << "its pull-up is no forward";
  EXPECT_THAT(answer_to(kProbeReleaseOutputs, 2), ElementsAre('r'));
  EXPECT_EQ(board.motor_duty().left, 0.0);
  EXPECT_EQ(board.motor_duty().right, 0.0);
}

TEST_P(EmulatedChip, TheServoHasNoPulseFromAPinThatIsNoOutput) {
  answer_to(kProbeCaptureEcho, 5);
  board.schedule_echo(board.now_ns() + kMs, board.now_ns() + 2 * kMs);
  run_ms(5);
  ASSERT_EQ(board.pan_pulse_us(), 1500.0);
  EXPECT_THAT(answer_to(kProbeReleaseOutputs, 2), ElementsAre('r'));
  EXPECT_EQ(board.pan_pulse_us(), 0.0);
}

TEST_P(EmulatedChip, TheSonarIsNotTriggeredByAPullUp) {
  int triggers = 0;
  board.on_trigger = [&](std::int64_t) { ++triggers; };
  EXPECT_THAT(answer_to(kProbePullUpTrigger, 5), ElementsAre('t'));
  EXPECT_EQ(triggers, 0);
  answer_to(kProbePulseTriggers, 5);
  EXPECT_EQ(triggers, 1);
}

TEST_P(EmulatedChip, ScheduledEdgesGoOnThroughAReset) {
  ask(kProbeWaitForWatchdog);
  constexpr std::int64_t kGapNs = 20'000;
  const std::int64_t start_ns = board.now_ns();
  for (std::int64_t i = 1; i * kGapNs < 30 * kMs; ++i) {
    board.schedule_encoder_edge(Wheel::kLeft, start_ns + i * kGapNs, i % 2 != 0, false);
  }
  run_ms(28);
  EXPECT_EQ(board.machine().resets(), 1U);
  for (int i = 0; i < 10; ++i) {
    const bool before = level(wiring.left_encoder_a);
    board.run_until(board.now_ns() + kGapNs);
    EXPECT_NE(level(wiring.left_encoder_a), before);
  }
}

TEST_P(EmulatedChip, ResetCutsTheByteUnderWay) {
  ask(kProbeSendBurst);
  run_ms(2);
  sent.clear();
  board.machine().reset(ResetSource::kExternal);
  run_ms(5);
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0].value, kExtrf);
}

TEST_P(EmulatedChip, StopsExactlyAtTheGrantedTimeAlsoInSleep) {
  ask(kProbeSleep100Ticks);
  run_ms(1);
  const auto expect_exact = [this](std::int64_t step_ns) {
    const std::int64_t until_ns = board.now_ns() + step_ns;
    board.run_until(until_ns);
    EXPECT_EQ(board.now_ns(), until_ns);
    const auto ahead = std::int64_t(board.machine().cycle()) - (until_ns * 2 + 124) / 125;
    EXPECT_GE(ahead, 0);
    EXPECT_LE(ahead, 12);
  };
  for (const std::int64_t step_ns : {1, 1000, 500'000, 999'983}) {
    expect_exact(step_ns);
  }
  for (int i = 0; i < 20'000; ++i) {  // every cycle of a tick, the first one of a sleep too
    expect_exact(i % 2 == 0 ? 62 : 63);
  }
}

TEST_P(EmulatedChip, SleepWithoutInterruptsIsAnError) {
  ask(kProbeSleepForEver);
  EXPECT_THROW(run_ms(5), std::runtime_error);
}

TEST(SimavrBoard, RejectsAFileThatIsNoAvrProgram) {
  EXPECT_THROW(SimavrBoard("/nonexistent.elf"), std::runtime_error);
  EXPECT_THROW(SimavrBoard("/proc/self/exe"), std::runtime_error);
  EXPECT_THROW(SimavrBoard(ECHOMAP_SOURCE_DIR "/LICENSE"), std::runtime_error);
}

TEST(SimavrBoard, SaysForWhichChipAProgramIsThatNoBoardRuns) {
  std::string program = files::read_text_file(probe_of("atmega328p"));
  const std::string chip = "atmega328p";
  program.replace(program.find(chip), chip.size(), "atmega32u4");
  const tests::ScratchFolder folder;
  const std::string elf = folder / "leonardo.elf";
  files::write_text_file(elf, program);
  EXPECT_THAT([&] { SimavrBoard board(elf); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  ::testing::AllOf(HasSubstr("atmega32u4"), HasSubstr("uno (atmega328p)"))));
}

TEST(SimavrBoard, RejectsANoteWithoutBytes) {
  tests::SmallAvrElf program("atmega328p");
  program.note.sh_type = SHT_NOBITS;
  const tests::ScratchFolder folder;
  files::write_text_file(folder / "bare.elf", program.text());
  EXPECT_THAT(
      [&] { SimavrBoard board(folder / "bare.elf"); },
      ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("does not say for which chip it is")));
}

/// An MPU-6050's address and name; remembers which registers were asked for.
class NamedDevice final : public world::TwoWireDevice {
 public:
  std::uint8_t address() const override { return 0x68; }
  void write(std::uint8_t, std::uint8_t) override { ADD_FAILURE() << "nothing was to be written"; }
  std::uint8_t read(std::uint8_t device_register) override {
    return device_register == 0x75 ? 0x68 : 0x99;
  }
};

TEST_P(EmulatedChip, ReadsTheRegistersOfATwoWireDevice) {
  NamedDevice device;
  board.connect(device);
  EXPECT_THAT(answer_to(kProbeReadDevice, 10),
              ElementsAre(0x08, 0x18, 0x28, 0x10, 0x40, 0x50, 0x68, 0x58, 0x99, 0x20));
}

TEST_P(EmulatedChip, NobodyAnswersOnAnEmptyBus) {
  const std::vector<std::uint8_t> answers = answer_to(kProbeReadDevice, 10);
  ASSERT_EQ(answers.size(), 10U);
  EXPECT_EQ(answers[1], 0x20);
  EXPECT_EQ(answers[4], 0x48);
}

TEST_P(EmulatedChip, ATwoWireByteTakesNineBitsAndAStartInterrupts) {
  const std::vector<std::uint8_t> answers = answer_to(kProbeTimeTwoWire, 10);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_NEAR(answers[0] | answers[1] << 8, 9 * 40, 25);
  EXPECT_EQ(answers[2], 1);
}

TEST_P(EmulatedChip, ConvertsTheVoltageOfItsLastChannel) {
  const unsigned last = wiring.spare_count - 1U;
  board.set_aux_millivolts(last - 1, 5000.0);
  board.set_aux_millivolts(last, 2500.0);
  EXPECT_THAT(answer_to(kProbeReadVoltage, 5), ElementsAre(0x00, 0x02));
  board.set_aux_millivolts(last, 5100.0);
  EXPECT_THAT(answer_to(kProbeReadVoltage, 5), ElementsAre(0xFF, 0x03));
}

TEST_P(EmulatedChip, ASparePinWithPulsesInterruptsAtEachChange) {
  const unsigned pin = wiring.spare_count == 16 ? 8U : 0U;
  board.set_aux_level(pin, true);
  ask(kProbeCountPinChanges);
  for (const std::int64_t us : {400, 900}) {
    board.schedule_aux_pulse(pin, board.now_ns() + us * 1000, board.now_ns() + (us + 100) * 1000);
  }
  board.schedule_aux_pulse(pin + 1, board.now_ns() + 700'000, board.now_ns() + 800'000);
  run_ms(5);
  EXPECT_THAT(answer(), ElementsAre(4));
}

TEST_P(EmulatedChip, ASparePinIsAnOutputWhereItsProgramDrivesIt) {
  EXPECT_FALSE(board.aux_output(0));
  EXPECT_THAT(answer_to(kProbeDriveSpares, 5), ElementsAre('o'));
  EXPECT_TRUE(board.aux_output(0));
  EXPECT_FALSE(board.aux_output(1)) << "it has a pull-up only";
  board.set_aux_level(1, false);
  EXPECT_FALSE(level(wiring.spare[1].pin));
  board.set_aux_level(1, true);
  EXPECT_TRUE(level(wiring.spare[1].pin));
}

TEST_P(EmulatedChip, RefusesASparePinThatItDoesNotHave) {
  EXPECT_THROW(board.set_aux_level(16, true), std::invalid_argument);
  EXPECT_THROW(board.set_aux_millivolts(0, 1000.0), std::invalid_argument) << "no channel";
}

}  // namespace
}  // namespace echomap::emulator
