#!/usr/bin/env bash
# Formats all C++ of the repository as .clang-format says. With --check it changes nothing and lists what differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
how=(-i)
if [ "${1:-}" = --check ]; then
    how=(--dry-run -Werror)
elif [ $# -gt 0 ]; then
    echo "usage: scripts/format.sh [--check]" >&2
    exit 2
fi
find include src apps python tests examples tools \( -name '*.cpp' -o -name '*.hpp' \) -not -path '*/node_modules/*' -print0 |
    xargs -0 -P "$(nproc)" -n 20 clang-format "${how[@]}"
