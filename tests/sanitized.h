#pragma once
// What a sanitizer does to tests: it keeps what is freed and holds shadows of what is touched, and it takes its time.

namespace gbl::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
inline constexpr double kSlowdown = 10;  // measured: 6, beside other work
#else
inline constexpr bool kSanitized = false;
inline constexpr double kSlowdown = 1;
#endif

}  // namespace gbl::test
