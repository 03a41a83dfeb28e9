// SPDX-License-Identifier: MIT
#pragma once

/// Marks a function that is smaller as one piece of code which is given its object: merged into its
/// caller, as avr-gcc does by itself, each byte of a global costs an instruction of four bytes.
#if defined(__AVR__)
#define ECHOMAP_ONE_PIECE __attribute__((noinline, noclone))
#else
#define ECHOMAP_ONE_PIECE
#endif
