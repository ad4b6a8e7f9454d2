#pragma once

/// In front of a function whose loops are worth the widest vector unit that a processor has: it is
/// compiled for several, of which the first call takes one. Since no sum is reordered or fused
/// (-ffp-contract=off), all of them have the same bits.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HWFFD_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define HWFFD_CLONES
#endif
