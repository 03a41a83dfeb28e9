// SPDX-License-Identifier: MIT
#pragma once

/// Put before the definition of a function whose loops gain from wide vectors: it is compiled for
/// plain x86-64, for SSE4 and for two levels with AVX, and the loader chooses by the processor.
/// Elsewhere, under sanitizers, which the choice runs too early for, and with ECHOMAP_ONE_PATH, for
/// benchmarks, it is compiled once.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(ECHOMAP_ONE_PATH)
#define ECHOMAP_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "arch=x86-64-v2", "default")))
/// The same without AVX-512, whose masked byte loads are slow where rows are short.
#define ECHOMAP_AVX2_CLONES \
  __attribute__((target_clones("arch=x86-64-v3", "arch=x86-64-v2", "default")))
#else
#define ECHOMAP_VECTOR_CLONES
#define ECHOMAP_AVX2_CLONES
#endif
