// SPDX-License-Identifier: MIT
/// A program for an emulated ATmega328P that asks one question of the chip per command byte and
/// sends the answer, so that tests see where the emulator differs from the data sheet.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/delay.h>

#include "tests/hil/probe/probe_commands.hpp"

namespace {

constexpr uint16_t kUbrr115200 = 16;
constexpr uint16_t kTimer1Top = 39999;

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
  PORTC = _BV(PC0) | _BV(PC1);
  PCMSK1 = _BV(PCINT8);
  PCIFR = _BV(PCIF1);
  PCICR = _BV(PCIE1);
  interrupts_seen = 0;
  sei();
  PORTC = _BV(PC0) | _BV(PC1) | _BV(PC5);
  DDRC = _BV(PC5);
  _delay_us(2);
  cli();
  PCICR = 0;
  send(PINC & _BV(PC0));
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

void start_timer1_mode_15() {
  OCR1A = kTimer1Top;
  OCR1B = 2999;
  DDRB |= _BV(PB2);
  TCCR1A = _BV(COM1B1) | _BV(WGM11) | _BV(WGM10);
  TCCR1B = _BV(WGM13) | _BV(WGM12) | _BV(CS11) | _BV(ICES1);
}

void capture_echo() {
  start_timer1_mode_15();
  TIFR1 = _BV(ICF1);
  send('c');
  while ((TIFR1 & _BV(ICF1)) == 0) {
  }
  captures[0] = ICR1;
  TCCR1B = TCCR1B & static_cast<uint8_t>(~_BV(ICES1));
  TIFR1 = _BV(ICF1);
  while ((TIFR1 & _BV(ICF1)) == 0) {
  }
  captures[1] = ICR1;
  const uint16_t rise = captures[0];
  const uint16_t fall = captures[1];
  send16(fall >= rise ? fall - rise : fall + (kTimer1Top + 1) - rise);
}

void pulse_triggers() {
  DDRB |= _BV(PB1);
  PORTB |= _BV(PB1);
  _delay_us(5);
  PORTB &= static_cast<uint8_t>(~_BV(PB1));
  _delay_us(50);
  PORTB |= _BV(PB1);
  _delay_us(11);
  PORTB &= static_cast<uint8_t>(~_BV(PB1));
  send('t');
}

void drive_motors() {
  DDRD |= _BV(PD4) | _BV(PD5) | _BV(PD6) | _BV(PD7);
  PORTD = (PORTD | _BV(PD4)) & static_cast<uint8_t>(~(_BV(PD5) | _BV(PD6) | _BV(PD7)));
  OCR0A = 191;
  OCR0B = 63;
  TCCR0A = _BV(COM0A1) | _BV(COM0B1) | _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS01) | _BV(CS00);
  send('m');
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
ISR(PCINT1_vect) { ++interrupts_seen; }
ISR(TIMER2_COMPA_vect) { --sleep_ticks_left; }

/// The first thing done on entry: when is it, on the timer that called?
ISR(TIMER1_COMPA_vect, ISR_NAKED) {
  asm volatile(
      "push r24 \n\t"
      "lds r24, %0 \n\t"
      "out %1, r24 \n\t"
      "lds r24, %0 + 1 \n\t"
      "out %2, r24 \n\t"
      "pop r24 \n\t"
      "reti"
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
