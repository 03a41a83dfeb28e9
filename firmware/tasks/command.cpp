// SPDX-License-Identifier: MIT
#include "firmware/tasks/command.hpp"

#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/boot.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/encoders.hpp"
#include "protocol/config_digest.hpp"
#include "protocol/version.hpp"

namespace echomap {
namespace tasks {

using protocol::CommandStatus;
using protocol::MotionOutcome;

namespace {

uint32_t capabilities() {
  uint32_t bits = protocol::kCapabilityWheels | protocol::kCapabilityPanSonar |
                  protocol::kCapabilityContacts | protocol::kCapabilityPins |
                  protocol::kCapabilityRanges | protocol::kCapabilityStepper;
  if (drivers::Gyro::can_be()) {
    bits |= protocol::kCapabilityGyro;
  }
  if (hal::aux_pin_count() != 0) {
    bits |= protocol::kCapabilityScalar;
  }
  if (!hal::encoders_tell_lost_steps()) {
    bits |= protocol::kCapabilityBlindEncoders;
  }
  return bits;
}

}  // namespace

void Command::announce() { reply(0); }

bool Command::poll() {
  uint8_t byte = 0;
  uint8_t taken = 0;
  while (taken < kBytesPerPoll && targets_.port.receive(byte)) {
    const protocol::DecodeStatus status = decoder_.take(byte);
    if (status != protocol::DecodeStatus::kIncomplete) {
      end_frame(status);
    }
    ++taken;
  }
  return taken != 0;
}

void Command::end_frame(protocol::DecodeStatus status) {
  const protocol::Frame frame = decoder_.frame();
  const bool whole = status == protocol::DecodeStatus::kFrame;
  if (whole && is_foreign_hello(frame)) {
    reply(filter_.session());
    return;
  }
  if (whole) {
    filter_.hear();
    targets_.sweep.listened();
  }
  if (whole && (!is_command(frame.id) || is_new(frame.payload[0]))) {
    protocol::Dispatcher<protocol::MessagesToRobot>::dispatch(frame.id, frame.payload, *this);
  }
  // After the message: a Hello of a new session begins the counting anew.
  targets_.received.take(status, frame.seq);
}

bool Command::is_foreign_hello(const protocol::Frame& frame) const {
  return frame.id == protocol::Hello::kId &&
         filter_.refuses(protocol::get_payload<protocol::Hello>(frame.payload).session);
}

bool Command::is_new(uint8_t command_id) {
  if (filter_.is_repeat(command_id)) {
    targets_.sender.answer(filter_.answer());
    return false;
  }
  const bool may_be_done = greeted_ && command_id != 0;
  if (!may_be_done) {
    const CommandStatus why = greeted_ ? CommandStatus::kOutOfRange : CommandStatus::kDisarmed;
    targets_.sender.answer(protocol::Ack{command_id, static_cast<uint8_t>(why)});
  }
  return may_be_done;
}

void Command::operator()(const protocol::Hello& hello) { begin_session(hello.session); }

void Command::operator()(const protocol::TakeOver& take_over) { begin_session(take_over.session); }

void Command::begin_session(uint16_t session) {
  if (filter_.begin_session(session)) {
    targets_.received.restart();
    disarm();
  }
  greeted_ = true;
  reply(session);
  targets_.telemetry.begin();
}

void Command::operator()(const protocol::Ping& ping) {
  targets_.sender.answer(protocol::Pong{ping.token, hal::now_us()});
}

void Command::operator()(const protocol::DriveSetpoint& setpoint) {
  const bool allowed =
      targets_.safety.armed() && Safety::accepts_time_to_live(setpoint.time_to_live_ms) &&
      !targets_.safety.blocks(setpoint.left_ticks_per_s, setpoint.right_ticks_per_s);
  if (allowed) {
    targets_.motion.drive(setpoint.left_ticks_per_s, setpoint.right_ticks_per_s);
    targets_.safety.renew(setpoint.time_to_live_ms);
  }
}

void Command::operator()(const protocol::KeepAlive& keep_alive) {
  if (Safety::accepts_time_to_live(keep_alive.time_to_live_ms)) {
    targets_.safety.renew(keep_alive.time_to_live_ms);
  }
}

void Command::operator()(const protocol::BulkRead& read) { targets_.bulk.ask(read); }

void Command::reply(uint16_t session) {
  targets_.sender.delimit();
  protocol::HelloReply reply{};
  reply.protocol_major = protocol::kProtocolMajor;
  reply.protocol_minor = protocol::kProtocolMinor;
  reply.schema_digest = protocol::kSchemaDigest;
  reply.firmware_version = protocol::kFirmwareVersion;
  reply.boot_id = hal::boot_id();
  reply.reset_cause = hal::reset_cause();
  reply.session = session;
  reply.tick_hz = hal::kTickHz;
  reply.receive_credit_bytes = drivers::SerialPort::kReceiveBytes;
  reply.capabilities = capabilities();
  reply.config_digest = protocol::config_digest(targets_.configuration);
  targets_.sender.answer(reply);
}

void Command::disarm() {
  targets_.safety.disarm();
  targets_.sweep.stop(MotionOutcome::kStopped);
}

CommandStatus Command::execute(const protocol::Arm& command) {
  filter_.hold(command.armed != 0);
  if (command.armed == 0) {
    disarm();
    return CommandStatus::kAccepted;
  }
  return targets_.safety.arm() ? CommandStatus::kAccepted : CommandStatus::kBlocked;
}

CommandStatus Command::execute(const protocol::Stop& /*command*/) {
  targets_.motion.stop(MotionOutcome::kStopped);
  targets_.sweep.stop(MotionOutcome::kStopped);
  return CommandStatus::kAccepted;
}

template <class Target, class Settings>
CommandStatus Command::configure(Target& target, const Settings& settings, bool busy) {
  if (busy) {
    return CommandStatus::kBusy;
  }
  if (!target.accepts(settings)) {
    return CommandStatus::kOutOfRange;
  }
  target.configure(settings);
  return CommandStatus::kAccepted;
}

CommandStatus Command::execute(const protocol::ConfigureDrive& command) {
  return configure(targets_.motion, command, targets_.motion.moving());
}

CommandStatus Command::execute(const protocol::ConfigurePan& command) {
  return configure(targets_.sweep, command, targets_.sweep.sweeping());
}

CommandStatus Command::execute(const protocol::ConfigureSonar& command) {
  return configure(targets_.sweep, command, targets_.sweep.sweeping());
}

CommandStatus Command::execute(const protocol::ConfigurePins& command) {
  const bool busy = targets_.motion.moving() || targets_.sweep.sweeping();
  return configure(targets_.sensors, command, busy);
}

CommandStatus Command::execute(const protocol::ConfigureSensors& command) {
  return configure(targets_.sensors, command, false);
}

CommandStatus Command::execute(const protocol::ConfigureSafety& command) {
  return configure(targets_.safety, command, targets_.motion.moving());
}

CommandStatus Command::execute(const protocol::ConfigureWiring& command) {
  if (targets_.motion.moving()) {
    return CommandStatus::kBusy;
  }
  constexpr uint8_t kContacts = uint8_t{hal::kContactLeft} | uint8_t{hal::kContactRight};
  drivers::SparePins& pins = targets_.sensors.pins();
  if (!targets_.motion.accepts(command) || command.contacts_normally_closed > kContacts ||
      !pins.can_take(drivers::pins_of_bridges(command))) {
    return CommandStatus::kOutOfRange;
  }
  targets_.motion.configure(command);
  pins.take(drivers::pins_of_bridges(command));
  targets_.configuration.wiring = command;
  targets_.safety.restart_contacts();
  return CommandStatus::kAccepted;
}

CommandStatus Command::execute(const protocol::ConfigureScalar& command) {
  return configure(targets_.sensors, command, false);
}

CommandStatus Command::execute(const protocol::MoveTicks& command) {
  if (!targets_.safety.armed()) {
    return CommandStatus::kDisarmed;
  }
  if (targets_.motion.moving()) {
    return CommandStatus::kBusy;
  }
  if (!targets_.motion.accepts(command) || !Safety::accepts_time_to_live(command.time_to_live_ms)) {
    return CommandStatus::kOutOfRange;
  }
  if (targets_.safety.blocks(command.left_ticks, command.right_ticks)) {
    return CommandStatus::kBlocked;
  }
  targets_.motion.start_move(command);
  targets_.safety.renew(command.time_to_live_ms);
  return CommandStatus::kAccepted;
}

CommandStatus Command::execute(const protocol::StartSweep& command) {
  if (targets_.sweep.sweeping()) {
    return CommandStatus::kBusy;
  }
  if (!targets_.sweep.accepts(command)) {
    return CommandStatus::kOutOfRange;
  }
  targets_.sweep.start(command);
  return CommandStatus::kAccepted;
}

}  // namespace tasks
}  // namespace echomap
