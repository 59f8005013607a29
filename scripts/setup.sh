#!/usr/bin/env bash
# Installs the Debian packages of scripts/packages.txt that are missing.
#   scripts/setup.sh          what building and running need
#   scripts/setup.sh --tests  what the tests need as well
# When nothing is missing it needs neither root nor a network.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

with_tests=no
for argument in "$@"; do
    case $argument in
    --tests) with_tests=yes ;;
    *) echo "usage: scripts/setup.sh [--tests]" >&2; exit 2 ;;
    esac
done

installed() { # PACKAGE [COMMAND]
    if [ -n "${2:-}" ] && command -v "$2" >/dev/null; then
        return 0
    fi
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

missing=()
while read -r package tool; do
    case $package in
    '' | '#'*) continue ;;
    '[test]')
        if [ $with_tests = no ]; then
            break
        fi
        continue
        ;;
    esac
    installed "$package" "$tool" || missing+=("$package")
done <"$here/packages.txt"

if [ ${#missing[@]} = 0 ]; then
    exit 0
fi
if ! command -v apt-get >/dev/null; then
    echo "setup: this is no Debian; please install: ${missing[*]}" >&2
    exit 1
fi
echo "setup: installing ${missing[*]}"
as_root=()
if [ "$(id -u)" != 0 ]; then
    as_root=(sudo)
fi
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
