// SPDX-License-Identifier: MIT
#pragma once

#include <avr/io.h>

/// What the probe program uses under other names on the board of each chip, as in
/// firmware/boards/*/pins.hpp. Vectors and registers are macros of avr-libc, so these are too.
#if defined(__AVR_ATmega2560__)

/// The encoders' port: bit 0 is the left A.
#define PROBE_ENCODER_PORT PORTB
#define PROBE_ENCODER_DDR DDRB
#define PROBE_ENCODER_PIN PINB
#define PROBE_ENCODER_MASK PCMSK0
#define PROBE_ENCODER_GROUP PCIE0
#define PROBE_ENCODER_vect PCINT0_vect

/// The timer of servo and echo.
#define PROBE_FRAME_TOP OCR5A
#define PROBE_FRAME_SERVO OCR5B
#define PROBE_FRAME_MODE TCCR5A
#define PROBE_FRAME_CONTROL TCCR5B
#define PROBE_FRAME_FLAGS TIFR5
#define PROBE_FRAME_CAPTURE ICR5

/// Trigger and servo.
#define PROBE_SONAR_PORT PORTL
#define PROBE_SONAR_DDR DDRL
constexpr uint8_t kTriggerPin = _BV(PL3);
constexpr uint8_t kServoPin = _BV(PL4);

/// The first two spare pins.
#define PROBE_SPARE_PORT PORTA
#define PROBE_SPARE_DDR DDRA
constexpr uint8_t kFirstSpare = _BV(PA0);
constexpr uint8_t kSecondSpare = _BV(PA1);

/// The first spare pin whose pulses the firmware counts: A8.
#define PROBE_PULSE_MASK PCMSK2
#define PROBE_PULSE_GROUP PCIE2
#define PROBE_PULSE_vect PCINT2_vect
constexpr uint8_t kPulsePin = _BV(PK0);

/// Left motor forward at 191 of 255, right motor backward at 63.
inline void drive_both_motors() {
  DDRG |= _BV(PG5);
  DDRH |= _BV(PH3) | _BV(PH4);
  DDRE |= _BV(PE3);
  PORTG |= _BV(PG5);
  OCR4A = 191;
  OCR3A = 63;
  TCCR4A = _BV(COM4A1) | _BV(WGM40);
  TCCR4B = _BV(WGM42) | _BV(CS41) | _BV(CS40);
  TCCR3A = _BV(COM3A1) | _BV(WGM30);
  TCCR3B = _BV(WGM32) | _BV(CS31) | _BV(CS30);
}

inline void release_left_direction() { DDRG &= static_cast<uint8_t>(~_BV(PG5)); }

/// PORTx stays.
inline void release_both_motors() {
  release_left_direction();
  DDRH &= static_cast<uint8_t>(~(_BV(PH3) | _BV(PH4)));
  DDRE &= static_cast<uint8_t>(~_BV(PE3));
}

#else

#define PROBE_ENCODER_PORT PORTC
#define PROBE_ENCODER_DDR DDRC
#define PROBE_ENCODER_PIN PINC
#define PROBE_ENCODER_MASK PCMSK1
#define PROBE_ENCODER_GROUP PCIE1
#define PROBE_ENCODER_vect PCINT1_vect

#define PROBE_FRAME_TOP OCR1A
#define PROBE_FRAME_SERVO OCR1B
#define PROBE_FRAME_MODE TCCR1A
#define PROBE_FRAME_CONTROL TCCR1B
#define PROBE_FRAME_FLAGS TIFR1
#define PROBE_FRAME_CAPTURE ICR1

#define PROBE_SONAR_PORT PORTB
#define PROBE_SONAR_DDR DDRB
constexpr uint8_t kTriggerPin = _BV(PB1);
constexpr uint8_t kServoPin = _BV(PB2);

#define PROBE_SPARE_PORT PORTB
#define PROBE_SPARE_DDR DDRB
constexpr uint8_t kFirstSpare = _BV(PB3);
constexpr uint8_t kSecondSpare = _BV(PB4);

#define PROBE_PULSE_MASK PCMSK0
#define PROBE_PULSE_GROUP PCIE0
#define PROBE_PULSE_vect PCINT0_vect
constexpr uint8_t kPulsePin = _BV(PB3);

inline void drive_both_motors() {
  DDRD |= _BV(PD4) | _BV(PD5) | _BV(PD6) | _BV(PD7);
  PORTD = (PORTD | _BV(PD4)) & static_cast<uint8_t>(~(_BV(PD5) | _BV(PD6) | _BV(PD7)));
  OCR0A = 191;
  OCR0B = 63;
  TCCR0A = _BV(COM0A1) | _BV(COM0B1) | _BV(WGM01) | _BV(WGM00);
  TCCR0B = _BV(CS01) | _BV(CS00);
}

inline void release_left_direction() { DDRD &= static_cast<uint8_t>(~_BV(PD4)); }

inline void release_both_motors() {
  DDRD &= static_cast<uint8_t>(~(_BV(PD4) | _BV(PD5) | _BV(PD6) | _BV(PD7)));
}

#endif
