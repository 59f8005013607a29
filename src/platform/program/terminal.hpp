#pragma once
#include <cstddef>
#include <cstdio>

namespace prelight {

/// Whether somebody looks at what is written there.
bool is_terminal(std::FILE* stream);
/// Columns of the stream's terminal; 80 where it is none.
size_t columns_of(std::FILE* stream);

} // namespace prelight
