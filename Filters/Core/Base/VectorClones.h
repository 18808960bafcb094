// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/**
 * Marks a function whose loops are to be compiled for several vector instruction sets, the best of
 * which is taken when the library is loaded. Floating-point contraction is off for the whole
 * library, so every version gives equal results.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define RUC_VECTOR_CLONES                                                                          \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define RUC_VECTOR_CLONES
#endif
