#pragma once

// Of a function whose loops take several numbers at once: in the form that suits the processor, eight floats where it
// can; it is asked once, when the program starts. For files to which src/CMakeLists.txt gives PRELIGHT_TARGET_CLONES.
#if defined(PRELIGHT_TARGET_CLONES) && !defined(__SANITIZE_ADDRESS__)
#define PRELIGHT_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define PRELIGHT_WIDE
#endif
