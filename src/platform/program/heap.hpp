#pragma once

namespace prelight {

/// How this process's heap grows and shrinks. Before anything else.
void set_up_heap();

} // namespace prelight
