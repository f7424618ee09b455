#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the terrain where it is not there yet, or older than its script (see Data/README.md).
#   Data/make_terrain.sh PYTHON OUT.vtp     PYTHON knows VTK: pvpython, or python3 with Debian's python3-vtk9
set -euo pipefail

fail() {
  printf 'error: %s\n' "$1" >&2
  exit 1
}

(($# == 2)) || fail "usage: Data/make_terrain.sh PYTHON OUT.vtp"
root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
python="$1"
file="$2"
log="${file%.vtp}.log"

[[ ! -f "$file" || "$root/Data/make_terrain.py" -nt "$file" ]] || exit 0
mkdir -p "$(dirname -- "$file")"
echo "Making $file"
"$python" "$root/Data/make_terrain.py" "$file" >"$log" 2>&1 ||
  fail "$(grep '^make_terrain: ' "$log" || echo "no terrain; all that $python said is in $log")"
