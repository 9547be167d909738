#pragma once

/// Compiles a hot loop once more for processors with wider vectors; the loader picks the version. Only for loops
/// without calls. Results are the same bits: contraction to fused multiply-adds is off for the whole project.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define FIDELIS_FOR_EVERY_PROCESSOR __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define FIDELIS_FOR_EVERY_PROCESSOR
#endif
