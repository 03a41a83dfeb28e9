// SPDX-License-Identifier: GPL-3.0-or-later

/// Asked by LeakSanitizer, in builds that have it: simavr never frees the names and hooks of its
/// interrupts' IRQs, about 6 kB for each machine.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): LeakSanitizer's
extern "C" const char* __lsan_default_suppressions();

// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): LeakSanitizer's
extern "C" const char* __lsan_default_suppressions() { return "leak:libsimavr\n"; }
