// What a light pass sums and where it puts it: no_light(), add_light(), write_sums(). Each kind of
// target has its own file with these three; the variant says which.
#ifdef COUNT_TARGET
#include "shared/light_count_sums.glsl"
#elif defined(DEFERRED_TARGET)
#include "shared/deferred_sums.glsl"
#else
#include "shared/light_buffer_sums.glsl"
#endif
