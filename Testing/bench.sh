#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs one benchmark.
#   Testing/bench.sh build [arguments of Google Benchmark]   the build of the tree
#   Testing/bench.sh python [POINTS [POSITIONS [REPETITIONS]]]   the locator from Python beside cKDTree
#   Testing/bench.sh locator [arguments]     writes build/bench/locator.md, .json and pictures;
#                                            locator --help lists its arguments
#   Testing/bench.sh paper [--quick] [arguments]   the paper's Tables 1 to 3, its claims and figures, in
#                                            build/bench/paper.md; 25 minutes, --quick three; --help as above
#   Testing/bench.sh --vtk build|locator [arguments]   these two beside Debian's own VTK (libvtk9-dev), which
#                                            is compiled with optimisation, while that in Debian's ParaView
#                                            is not; on a machine without ParaView, in build/vtk
set -euo pipefail

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
[[ "${1:-}" != -h && "${1:-}" != --help ]] || exec "$root/Plugin/usage.sh" "$0"
build="$root/build"
python=pvpython
host=()
declare -A benchmarks=([build]=BenchmarkOctreeBuild [locator]=BenchmarkPointLocator
  [paper]=BenchmarkPaper [python]=benchmark_python.py)

fail() {
  printf 'error: %s\n' "$1" >&2
  exit 1
}

# The value that the arguments give an option: get_option NAME DEFAULT ARGUMENT...
get_option() {
  local name="$1" value="$2"
  shift 2
  while (($#)); do
    case "$1" in
      "$name"=?*) value="${1#*=}" ;;
      "$name" | "$name"=)
        [[ "$1" == "$name" && -n "${2:-}" ]] || fail "$name needs a value"
        value="$2" ;;
    esac
    shift
  done
  printf '%s\n' "$value"
}

# This and the next draw also when some answers were wrong (1), but not when the arguments were (2).
run_paper() {
  local quick=() status=0 plugin points markdown output log
  [[ " $* " != *' --help '* ]] || exec "$program" --help
  points="$(get_option --points '' "$@")"
  markdown="$(get_option --output "$root/build/bench/paper.md" "$@")"
  output="$(dirname -- "$markdown")"
  log="$output/draw.log"
  [[ " $* " != *' --quick '* ]] || quick=(--quick)
  plugin="$("$root/Plugin/find_plugin.sh")"
  if [[ -z "$points" ]]; then
    points="$root/build/data/points"
    python3 "$root/Data/make_point_sets.py" "$points" "${quick[@]}"
  fi
  mkdir -p "$output"
  "$program" --points "$points" --output "$markdown" "$@" || status=$?
  ((status <= 1)) || exit "$status"
  PYTHONDONTWRITEBYTECODE=1 "$root/Plugin/with_display.sh" pvpython --dr "$root/Testing/Benchmarks/draw_paper.py" \
    --plugin "$plugin" --points "$points" --output "$output" --markdown "$markdown" >"$log" 2>&1 ||
    fail "$(grep '^draw_paper: ' "$log" || echo "no pictures; all that pvpython said is in $log")"
  echo "Tables and pictures are in $markdown"
  exit "$status"
}

run_locator() {
  local terrain="$build/data/terrain.vtp" output points status=0
  output="$(get_option --output "$build/bench" "$@")"
  points="$(get_option --points '' "$@")"
  [[ -n "$points" ]] || "$root/Data/make_terrain.sh" "$python" "$terrain"
  mkdir -p "$output"
  "$program" --terrain "$terrain" --output "$output" "$@" || status=$?
  ((status <= 1)) || exit "$status"
  if [[ " $* " != *' --help '* ]]; then
    rm -f "$output"/locator-*.png # Those of other data, from a run before.
    python3 "$root/Testing/Benchmarks/plot_locator.py" "$output/locator.json" "$output"
  fi
  exit "$status"
}

if [[ "${1:-}" == --vtk ]]; then
  build="$root/build/vtk"
  python=python3
  host=(--vtk)
  unset 'benchmarks[paper]' 'benchmarks[python]'
  shift
fi
name="${1:-}"
[[ -n "$name" && -n "${benchmarks[$name]:-}" ]] ||
  fail "no benchmark \"$name\"; there is: ${!benchmarks[*]}"
shift
"$root/Plugin/setup.sh" "${host[@]}" --benchmarks
PATH="/usr/bin:/bin:$PATH" # Debian's ParaView, as in setup.sh
program="$build/bin/${benchmarks[$name]}"
if [[ "$name" == python ]]; then
  export PYTHONPATH="$root/build/lib/python3/dist-packages"
  exec python3 -B "$root/Testing/Benchmarks/${benchmarks[$name]}" "$@"
fi
[[ "$name" != locator ]] || run_locator "$@"
[[ "$name" != paper ]] || run_paper "$@"
exec "$program" "$@"
