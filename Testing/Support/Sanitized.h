// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_Sanitized_h
#define Testing_Support_Sanitized_h

/** Whether the tests run under a sanitizer, many times slower: then large ones take fewer points,
 * or are skipped, and times do not count. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) // As GCC tells of it,
constexpr bool Sanitized = true;
#elif defined(__has_feature) // and as Clang does.
constexpr bool Sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool Sanitized = false;
#endif

#endif
