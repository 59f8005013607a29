#include <prelight/reference.hpp>
