#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets everything up and runs one benchmark.
#   Testing/bench.sh build [arguments of Google Benchmark]   the build of the tree
#   Testing/bench.sh python [POINTS [POSITIONS [REPETITIONS]]]   the locator from Python beside cKDTree
#   Testing/bench.sh locator [arguments]     writes build/bench/locator.md, .json and pictures;
#                                            --help tells its own arguments
#   Testing/bench.sh paper [--quick] [--repetitions N]   the paper's Tables 1 to 3, its claims and figures,
#                                            in build/bench/paper.md; 25 minutes, --quick one
#   Testing/bench.sh --vtk build|locator [arguments]   these two beside Debian's own VTK (libvtk9-dev), which
#                                            is compiled with optimisation, while that in Debian's ParaView
#                                            is not; on a machine without ParaView, in build/vtk
set -euo pipefail

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
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

# This and the next draw also when some answers were wrong (1), but not when the arguments were (2).
run_paper() {
  local points="$root/build/data/points" output="$root/build/bench" log="$root/build/bench/draw.log"
  local quick=() status=0 plugin
  [[ " $* " != *' --help '* ]] || exec "$program" --help
  [[ " $* " != *' --quick '* ]] || quick=(--quick)
  plugin="$("$root/Plugin/find_plugin.sh")"
  python3 "$root/Data/make_point_sets.py" "$points" "${quick[@]}"
  mkdir -p "$output"
  "$program" --points "$points" --output "$output/paper.md" "$@" || status=$?
  ((status <= 1)) || exit "$status"
  PYTHONDONTWRITEBYTECODE=1 "$root/Plugin/with_display.sh" pvpython --dr "$root/Testing/Benchmarks/draw_paper.py" \
    --plugin "$plugin" --points "$points" --output "$output" --markdown "$output/paper.md" >"$log" 2>&1 ||
    fail "$(grep '^draw_paper: ' "$log" || echo "no pictures; all that pvpython said is in $log")"
  echo "Tables and pictures are in $output/paper.md"
  exit "$status"
}

run_locator() {
  local terrain="$build/data/terrain.vtp" output="$build/bench" status=0
  "$root/Data/make_terrain.sh" "$python" "$terrain"
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
