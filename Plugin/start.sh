#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up, then shows the octree of the points in FILE in ParaView.
#   Plugin/start.sh [--batch] [FILE]
# FILE is anything that ParaView reads (.ply .obj .stl .vtp .vtk .vtu ...), or text (.csv .tsv .txt .xyz
# .asc) with columns x, y and z, or with these first and no names; without it, a measured terrain is
# shown. Without a display, or with --batch, pictures and tables are written to build/demo/ instead.
set -euo pipefail

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
demo="$root/build/demo"
log="$demo/demo.log"

fail() {
  printf 'error: %s\n' "$1" >&2
  exit 1
}

read_arguments() {
  batch=no
  file=
  [[ -n "${DISPLAY:-}" ]] || batch=yes # ParaView comes without what Wayland alone needs
  while (($#)); do
    case "$1" in
      -h | --help) exec "$root/Plugin/usage.sh" "$0" ;;
      --batch) batch=yes ;;
      -*) fail "unknown option $1; try --help" ;;
      *)
        [[ -z "$file" ]] || fail "one FILE at a time; try --help"
        file="$1"
        check_file ;;
    esac
    shift
  done
}

check_file() {
  [[ -e "$file" ]] || fail "$file does not exist; give the path of a file that ParaView can read"
  [[ -f "$file" ]] || fail "$file is not a file; give the path of a file that ParaView can read"
  [[ -r "$file" ]] || fail "$file cannot be read; check its permissions"
  file="$(realpath -- "$file")"
}

show_in_paraview() {
  echo "Opening ParaView; its messages go to $log"
  # --dr: ParaView's welcome window would hold the script up, and the user's settings stay as they are.
  paraview --dr --plugin-search-paths="${plugin%/*}" --plugins=HashedOctree \
    --script="$root/Plugin/Demo/demo.py" >"$log" 2>&1 || fail_with_log
}

write_pictures() {
  "$root/Plugin/with_display.sh" pvpython "$root/Plugin/Demo/demo.py" \
    --batch --plugin "$plugin" --output "$demo" 2>"$log" || fail_with_log
  echo "Pictures and tables are in $demo"
}

# Passes on the exit code and the one line that our script wrote; all else in the log is ParaView's.
fail_with_log() {
  local code=$?
  # By Ctrl-C, or by SIGTERM.
  ((code != 130 && code != 143)) || exit "$code"
  grep -a '^demo: ' "$log" >&2 || {
    tail -n 20 "$log" >&2
    printf 'error: %s; the last lines are above, all of it is in %s\n' "$(explain "$code")" "$log" >&2
  }
  exit "$code"
}

explain() {
  if grep -q 'could not connect to display' "$log"; then
    printf 'no display at %s; give another, or --batch for pictures' "${DISPLAY:-}"
  elif (($1 > 128)); then
    printf 'ParaView crashed; if it cannot read %s, save that as .vtp, .ply or .csv' "$file"
  else
    printf 'ParaView failed'
  fi
}

read_arguments "$@"
"$root/Plugin/setup.sh"
PATH="/usr/bin:/bin:$PATH" # Debian's ParaView, as in setup.sh
mkdir -p "$demo"
if [[ -z "$file" ]]; then
  file="$root/build/data/terrain.vtp"
  "$root/Data/make_terrain.sh" pvpython "$file"
fi
export HASHEDOCTREE_FILE="$file"
plugin="$("$root/Plugin/find_plugin.sh")"
export PYTHONPATH="$root/build/lib/python3/dist-packages:$root/Plugin/Demo${PYTHONPATH:+:$PYTHONPATH}"
export PYTHONDONTWRITEBYTECODE=1 # so that nothing is written into Plugin/
export VTK_SMP_BACKEND_IN_USE="${VTK_SMP_BACKEND_IN_USE:-STDThread}" # ParaView's own is one thread
if [[ $batch == yes ]]; then
  write_pictures
else
  show_in_paraview
fi
