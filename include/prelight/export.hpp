#pragma once

/// Marks what the shared library offers to programs. All else in it is hidden (packaging/prelight.map).
#define PRELIGHT_API __attribute__((visibility("default")))
