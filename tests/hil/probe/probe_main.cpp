// SPDX-License-Identifier: MIT
/// A program for an emulated ATmega that asks one question of the chip per command byte and
/// sends the answer, so that tests see where the emulator differs from the data sheet.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/delay.h>

#include "tests/hil/probe/probe_commands.hpp"
#include "tests/hil/probe/probe_pins.hpp"

namespace {

constexpr uint16_t kUbrr115200 = 16;
/// 16 MHz / (16 + 2 x 12).
constexpr uint8_t kTwbr400k = 12;
constexpr uint8_t kDevice = 0x68;
constexpr uint16_t kFrameTop = 39999;

volatile uint8_t interrupts_seen;
volatile uint8_t sleep_ticks_left;
volatile uint16_t captures[2];
uint8_t survivor __attribute__((section(".noinit")));

void start_uart() {
  UCSR0A = _BV(U2X0);
  UBRR0 = kUbrr115200;
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
  UCSR0B = _BV(RXEN0) | _BV(TXEN0);
}

void send(uint8_t byte) {
  while ((UCSR0A & _BV(UDRE0)) == 0) {
  }
  UDR0 = byte;
}

void send16(uint16_t value) {
  send(static_cast<uint8_t>(value));
  send(static_cast<uint8_t>(value >> 8));
}

uint8_t wait_for_byte() {
  while ((UCSR0A & _BV(RXC0)) == 0) {
  }
  return UDR0;
}

void send_burst() {
  for (uint8_t i = 0; i < 100; ++i) {
    send(i);
  }
}

void overrun_receiver() {
  _delay_ms(20);
  const uint8_t overrun = UCSR0A & _BV(DOR0);
  uint8_t count = 0;
  while ((UCSR0A & _BV(RXC0)) != 0) {
    static_cast<void>(UDR0);
    ++count;
  }
  send(count);
  send(overrun != 0 ? 1 : 0);
}

void let_timer0_raise_flags() {
  OCR0A = 10;
  OCR0B = 20;
  TCNT0 = 0;
  TCCR0B = _BV(CS00);
  _delay_us(40);
  TCCR0B = 0;
}

void clear_one_flag() {
  let_timer0_raise_flags();
  send(TIFR0);
  TIFR0 = _BV(OCF0A);
  send(TIFR0);
  TIFR0 = _BV(OCF0B) | _BV(TOV0);
  send(TIFR0);
}

void enable_after_flag() {
  interrupts_seen = 0;
  let_timer0_raise_flags();
  TIMSK0 = _BV(OCIE0A);
  sei();
  _delay_us(2);
  cli();
  TIMSK0 = 0;
  send(interrupts_seen);
}

void time_interrupt_entry() {
  TCCR1A = 0;
  TCCR1B = _BV(CS10);
  OCR1A = 1000;
  TCNT1 = 0;
  TIFR1 = _BV(OCF1A);
  TIMSK1 = _BV(OCIE1A);
  sei();
  _delay_us(100);
  cli();
  TIMSK1 = 0;
  send16(static_cast<uint16_t>(GPIOR1 | (GPIOR2 << 8)));
}

void write_port_with_pull_up() {
  PROBE_ENCODER_PORT = _BV(0) | _BV(1);
  PROBE_ENCODER_MASK = _BV(0);
  PCIFR = _BV(PROBE_ENCODER_GROUP);
  PCICR = _BV(PROBE_ENCODER_GROUP);
  interrupts_seen = 0;
  sei();
  PROBE_ENCODER_PORT = _BV(0) | _BV(1) | _BV(5);
  PROBE_ENCODER_DDR = _BV(5);
  _delay_us(2);
  cli();
  PCICR = 0;
  send(PROBE_ENCODER_PIN & _BV(0));
  send(interrupts_seen);
}

void wait_for_watchdog() {
  survivor = 77;
  wdt_enable(WDTO_15MS);
  for (;;) {
  }
}

void sleep_100_ticks() {
  OCR2A = 249;
  TCCR2A = _BV(WGM21);
  TCNT2 = 0;
  TIFR2 = _BV(OCF2A);
  TCCR2B = _BV(CS22);
  TIMSK2 = _BV(OCIE2A);
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_ticks_left = 100;
  sei();
  while (sleep_ticks_left != 0) {
    sleep_mode();
  }
  cli();
  TIMSK2 = 0;
  send('z');
}

/// All 16-bit timers have the bits of timer 1.
void start_frame_timer() {
  PROBE_FRAME_TOP = kFrameTop;
  PROBE_FRAME_SERVO = 2999;
  PROBE_SONAR_DDR |= kServoPin;
  PROBE_FRAME_MODE = _BV(COM1B1) | _BV(WGM11) | _BV(WGM10);
  PROBE_FRAME_CONTROL = _BV(WGM13) | _BV(WGM12) | _BV(CS11) | _BV(ICES1);
}

void capture_echo() {
  start_frame_timer();
  PROBE_FRAME_FLAGS = _BV(ICF1);
  send('c');
  while ((PROBE_FRAME_FLAGS & _BV(ICF1)) == 0) {
  }
  captures[0] = PROBE_FRAME_CAPTURE;
  PROBE_FRAME_CONTROL = PROBE_FRAME_CONTROL & static_cast<uint8_t>(~_BV(ICES1));
  PROBE_FRAME_FLAGS = _BV(ICF1);
  while ((PROBE_FRAME_FLAGS & _BV(ICF1)) == 0) {
  }
  captures[1] = PROBE_FRAME_CAPTURE;
  const uint16_t rise = captures[0];
  const uint16_t fall = captures[1];
  send16(fall >= rise ? fall - rise : fall + (kFrameTop + 1) - rise);
}

void pulse_triggers() {
  PROBE_SONAR_DDR |= kTriggerPin;
  PROBE_SONAR_PORT |= kTriggerPin;
  _delay_us(5);
  PROBE_SONAR_PORT &= static_cast<uint8_t>(~kTriggerPin);
  _delay_us(50);
  PROBE_SONAR_PORT |= kTriggerPin;
  _delay_us(11);
  PROBE_SONAR_PORT &= static_cast<uint8_t>(~kTriggerPin);
  send('t');
}

void drive_motors() {
  drive_both_motors();
  send('m');
}

void release_forward() {
  release_left_direction();
  send('r');
}

void release_outputs() {
  release_both_motors();
  PROBE_SONAR_DDR &= static_cast<uint8_t>(~kServoPin);
  send('r');
}

void pull_up_trigger() {
  PROBE_SONAR_DDR &= static_cast<uint8_t>(~kTriggerPin);
  PROBE_SONAR_PORT |= kTriggerPin;
  _delay_us(11);
  PROBE_SONAR_PORT &= static_cast<uint8_t>(~kTriggerPin);
  send('t');
}

/// Lets the two-wire bus do what `control` says; what TWSR says then.
uint8_t two_wire(uint8_t control) {
  TWCR = _BV(TWINT) | _BV(TWEN) | control;
  while ((TWCR & _BV(TWINT)) == 0) {
  }
  return TWSR;
}

uint8_t two_wire_send(uint8_t byte) {
  TWDR = byte;
  return two_wire(0);
}

void end_two_wire() {
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
  while ((TWCR & _BV(TWSTO)) != 0) {
  }
}

void read_device() {
  TWBR = kTwbr400k;
  send(two_wire(_BV(TWSTA)));
  send(two_wire_send(kDevice << 1));
  send(two_wire_send(0x75));
  send(two_wire(_BV(TWSTA)));
  send(two_wire_send(kDevice << 1 | 1));
  send(two_wire(_BV(TWEA)));
  send(TWDR);
  send(two_wire(0));
  send(TWDR);
  end_two_wire();
  two_wire(_BV(TWSTA));
  send(two_wire_send((kDevice + 1) << 1));
  end_two_wire();
  TWCR = 0;
}

void time_two_wire() {
  TWBR = kTwbr400k;
  two_wire(_BV(TWSTA));
  TCCR1A = 0;
  TCCR1B = _BV(CS10);
  TCNT1 = 0;
  two_wire_send(kDevice << 1);
  send16(TCNT1);
  end_two_wire();
  interrupts_seen = 0;
  sei();
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWIE) | _BV(TWSTA);
  _delay_us(20);
  cli();
  send(interrupts_seen);
  TWCR = 0;
}

void read_voltage() {
  ADMUX = _BV(REFS0) | 7;
#if defined(MUX5)
  ADCSRB = _BV(MUX5);
#endif
  ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
  while ((ADCSRA & _BV(ADSC)) != 0) {
  }
  send16(ADC);
}

void count_pin_changes() {
  PROBE_PULSE_MASK = kPulsePin;
  PCIFR = _BV(PROBE_PULSE_GROUP);
  PCICR = _BV(PROBE_PULSE_GROUP);
  interrupts_seen = 0;
  sei();
  _delay_ms(2);
  cli();
  PCICR = 0;
  send(interrupts_seen);
}

void drive_spares() {
  PROBE_SPARE_DDR |= kFirstSpare;
  PROBE_SPARE_PORT |= kFirstSpare | kSecondSpare;
  send('o');
}

void answer(uint8_t command) {
  switch (command) {
    case kProbeSendBurst:
      return send_burst();
    case kProbeOverrunReceiver:
      return overrun_receiver();
    case kProbeClearOneFlag:
      return clear_one_flag();
    case kProbeEnableAfterFlag:
      return enable_after_flag();
    case kProbeTimeInterruptEntry:
      return time_interrupt_entry();
    case kProbeWritePortWithPullUp:
      return write_port_with_pull_up();
    case kProbeWaitForWatchdog:
      return wait_for_watchdog();
    case kProbeSleep100Ticks:
      return sleep_100_ticks();
    case kProbeCaptureEcho:
      return capture_echo();
    case kProbePulseTriggers:
      return pulse_triggers();
    case kProbeDriveMotors:
      return drive_motors();
    case kProbeReleaseForward:
      return release_forward();
    case kProbeReleaseOutputs:
      return release_outputs();
    case kProbePullUpTrigger:
      return pull_up_trigger();
    case kProbeReadDevice:
      return read_device();
    case kProbeTimeTwoWire:
      return time_two_wire();
    case kProbeReadVoltage:
      return read_voltage();
    case kProbeCountPinChanges:
      return count_pin_changes();
    case kProbeDriveSpares:
      return drive_spares();
    case kProbeSleepForEver:
      cli();
      sleep_mode();
      return;
    default:
      return;
  }
}

}  // namespace

ISR(TIMER0_COMPA_vect) { ++interrupts_seen; }
ISR(PROBE_ENCODER_vect) { ++interrupts_seen; }
ISR(PROBE_PULSE_vect) { ++interrupts_seen; }
/// Leaves TWINT for whoever goes on.
ISR(TWI_vect) {
  ++interrupts_seen;
  TWCR = _BV(TWEN);
}
ISR(TIMER2_COMPA_vect) { --sleep_ticks_left; }

/// The first thing done on entry: when is it, on the timer that called?
ISR(TIMER1_COMPA_vect, ISR_NAKED) {
  asm volatile(
      "push r24 \n\tlds r24, %0 \n\tout %1, r24 \n\tlds r24, %0 + 1 \n\tout %2, r24 \n\tpop r24 "
      "\n\treti"
      :
      : "n"(_SFR_MEM_ADDR(TCNT1L)), "I"(_SFR_IO_ADDR(GPIOR1)), "I"(_SFR_IO_ADDR(GPIOR2)));
}

int main() {
  const uint8_t cause = MCUSR;
  MCUSR = 0;
  wdt_disable();
  start_uart();
  send(cause);
  send(survivor);
  for (;;) {
    answer(wait_for_byte());
  }
}
