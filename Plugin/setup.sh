#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing and builds. A second run with nothing to do takes a second.
#   Plugin/setup.sh                              the plugin and the Python package, in build/
#   Plugin/setup.sh --vtk                        the library for Debian's own VTK, in build/vtk
#   Plugin/setup.sh --sanitize address|thread    the tests with a sanitizer, in build/asan or build/tsan
#   Plugin/setup.sh --fuzz                       the fuzzers, in build/fuzz
#   Plugin/setup.sh --machine aarch64|s390x      the core's tests for another machine, in build/aarch64 or
#                                                build/s390x; ctest runs them in an emulator
# Each of them also takes --tests, --benchmarks or both, in any order, and then builds these, too.
set -euo pipefail

root="$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")"
[[ "${1:-}" != -h && "${1:-}" != --help ]] || exec "$root/Plugin/usage.sh" "$0"
# Debian's tools first: a cmake or python3 from elsewhere does not fit Debian's ParaView.
PATH="/usr/sbin:/usr/bin:/sbin:/bin:$PATH"

tools=(g++ cmake ninja-build)
paraview_packages=(paraview paraview-dev python3-paraview python3-dev libopenmpi-dev libdouble-conversion-dev
  qttools5-dev qtxmlpatterns5-dev-tools # for the pages of help
  xvfb xauth libgl1-mesa-dri libqt5svg5) # the last: ParaView's icons
vtk_packages=(libvtk9-dev python3-vtk9 python3-matplotlib)
fuzz_packages=(clang libclang-rt-dev llvm) # llvm names the lines of a crash
machine_packages=(qemu-user) # and the machine's compiler
test_packages=(libgtest-dev openmpi-bin clang-format clang-tidy libbenchmark-dev libnanoflann-dev)
benchmark_packages=(libbenchmark-dev libnanoflann-dev python3-scipy)
paraview_options=(HASHEDOCTREE_HOST:STRING=PARAVIEW Python3_EXECUTABLE:FILEPATH=/usr/bin/python3)
vtk_options=(HASHEDOCTREE_HOST:STRING=VTK HASHEDOCTREE_PYTHON:STRING=OFF)
sanitizer_options=(CMAKE_BUILD_TYPE:STRING=RelWithDebInfo
  CMAKE_UNITY_BUILD:BOOL=ON # the libraries compile in two thirds of the time
  HASHEDOCTREE_PLUGIN:BOOL=OFF HASHEDOCTREE_PYTHON:STRING=OFF)
address_options=(HASHEDOCTREE_SANITIZE:STRING=address,undefined
  'CMAKE_CXX_FLAGS_RELWITHDEBINFO:STRING=-Og -g1' # compiles in half the time
  HASHEDOCTREE_64BIT_IDS:BOOL=ON) # so that both widths are tested
thread_options=(HASHEDOCTREE_SANITIZE:STRING=thread
  'CMAKE_CXX_FLAGS_RELWITHDEBINFO:STRING=-O1 -g1') # few tests, which then run in three fifths of the time
fuzz_options=(CMAKE_BUILD_TYPE:STRING=RelWithDebInfo 'CMAKE_CXX_FLAGS_RELWITHDEBINFO:STRING=-O2 -g1'
  CMAKE_CXX_COMPILER:STRING=/usr/bin/clang++ HASHEDOCTREE_HOST:STRING=NONE HASHEDOCTREE_FUZZ:BOOL=ON)

# With MACHINE in place of the machine's name.
machine_options=(HASHEDOCTREE_HOST:STRING=NONE
  CMAKE_SYSTEM_NAME:STRING=Linux CMAKE_SYSTEM_PROCESSOR:STRING=MACHINE
  CMAKE_C_COMPILER:STRING=/usr/bin/MACHINE-linux-gnu-gcc
  CMAKE_CXX_COMPILER:STRING=/usr/bin/MACHINE-linux-gnu-g++
  'CMAKE_CROSSCOMPILING_EMULATOR:STRING=/usr/bin/qemu-MACHINE;-L;/usr/MACHINE-linux-gnu')

fail() {
  printf 'error: %s\n' "$1" >&2
  exit 1
}

read_arguments() {
  kind=plugin
  tests=no
  benchmarks=no
  while (($#)); do
    case "$1" in
      --vtk) set_kind vtk ;;
      --sanitize)
        [[ "${2:-}" == address || "${2:-}" == thread ]] || fail "--sanitize takes address or thread"
        set_kind "$2"
        shift ;;
      --fuzz) set_kind fuzz ;;
      --machine)
        [[ "${2:-}" == aarch64 || "${2:-}" == s390x ]] || fail "--machine takes aarch64 or s390x"
        set_kind "$2"
        shift ;;
      --tests) tests=yes ;;
      --benchmarks) benchmarks=yes ;;
      *) fail "unknown option $1; try --help" ;;
    esac
    shift
  done
}

set_kind() {
  [[ $kind == plugin || $kind == "$1" ]] ||
    fail "--vtk, --sanitize, --fuzz and --machine have a build each; give one of them at a time"
  kind="$1"
}

choose_build() {
  build="$root/build"
  packages=("${tools[@]}")
  options=(HASHEDOCTREE_WERROR:BOOL=ON)
  excluded= # a package that must not be there
  case $kind in
    vtk)
      build+=/vtk
      packages+=("${vtk_packages[@]}")
      options+=("${vtk_options[@]}")
      excluded=python3-paraview ;;
    fuzz)
      build+=/fuzz
      packages+=("${fuzz_packages[@]}")
      options+=("${fuzz_options[@]}") ;;
    aarch64 | s390x)
      build+="/$kind"
      tests=yes
      packages+=("${machine_packages[@]}" "g++-$kind-linux-gnu")
      options+=("${machine_options[@]//MACHINE/$kind}") ;;
    *)
      packages+=("${paraview_packages[@]}")
      options+=("${paraview_options[@]}") ;;
  esac
  case $kind in
    address)
      build+=/asan
      tests=yes
      options+=("${sanitizer_options[@]}" "${address_options[@]}") ;;
    thread)
      build+=/tsan
      tests=yes
      options+=("${sanitizer_options[@]}" "${thread_options[@]}") ;;
  esac
  if [[ $tests == yes ]]; then
    packages+=("${test_packages[@]}")
    options+=(BUILD_TESTING:BOOL=ON)
  fi
  if [[ $benchmarks == yes ]]; then
    packages+=("${benchmark_packages[@]}")
    options+=(HASHEDOCTREE_BENCHMARKS:BOOL=ON)
  fi
  log="$build/setup.log"
}

missing_packages() {
  local installed package
  installed="$(dpkg-query --show --showformat '${Package} ${db:Status-Status}\n' \
    "$@" 2>/dev/null)" || true # it also fails when one of them is unknown
  for package in "$@"; do
    grep --quiet --line-regexp --fixed-strings "$package installed" <<<"$installed" || echo "$package"
  done
}

# Reads the output of a long command: all of it goes to the log, its percentages to the terminal.
show_progress() {
  local line percent shown=-1
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    # apt says "dlstatus:1:12.5:..." or "pmstatus:cmake:12.5:...", ninja "[ 12%] ..."
    [[ $line =~ ^(dlstatus:[^:]*:|pmstatus:[^:]*:|\[\ *)([0-9]+) ]] || continue
    percent="${BASH_REMATCH[2]}"
    ((percent / 10 > shown)) || continue
    ((shown >= 0)) || printf '%s:' "$1"
    shown=$((percent / 10))
    printf ' %d%%' "$percent"
  done
  ((shown < 0)) || printf '\n'
}

# apt reports its progress on 3, which sudo would close; if that were 1, packages would have no output.
# A daemon that a package starts must not keep the lock, on 9.
apt_get() {
  "${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
    sh -c 'exec apt-get -o Dpkg::Use-Pty=0 -o APT::Status-Fd=3 "$@" 3>&1 2>&1' \
    apt-get -o DPkg::Lock::Timeout=600 --no-install-recommends "$@" 9>&-
}

fail_apt() {
  grep '^E: ' "$log" | tail -n 1 >&2 || true
  fail "$1; all that apt-get said is in $log"
}

become_root() {
  as_root=()
  ((EUID == 0)) && return
  command -v sudo >/dev/null || fail "not root, and no sudo; as root, run: apt-get install $*"
  as_root=(sudo)
  sudo -v || fail "sudo refuses; ask an administrator to run: apt-get install $*"
}

install_packages() {
  echo "Missing packages: $*"
  become_root "$@"
  apt_get update >>"$log" || true # old lists may do; if not, the next steps fail and say so

  local plan
  plan="$(apt_get --assume-no install "$@")" || true # it fails, having been told "no"
  printf '%s\n' "$plan" >>"$log"
  grep --quiet 'newly installed' <<<"$plan" ||
    fail_apt "apt-get cannot find what is missing; is the network up, and is this Debian 12?"
  grep -E 'newly installed|^Need to get|^After this operation' <<<"$plan"

  apt_get --yes --download-only install "$@" | show_progress 'Downloading' ||
    fail_apt "apt-get could not download; is the network up, and is there room on the disk?"
  apt_get --yes install "$@" | show_progress 'Installing' || fail_apt "apt-get could not install"
}

install_missing() {
  command -v apt-get >/dev/null ||
    fail "no apt-get here; install what these Debian packages hold, then use cmake: ${packages[*]}"
  [[ -z "$excluded" || -n "$(missing_packages "$excluded")" ]] ||
    fail "Debian has either its own VTK or its ParaView on a machine; remove $excluded, or use another one"
  local missing
  mapfile -t missing < <(missing_packages "${packages[@]}")
  ((${#missing[@]} == 0)) || install_packages "${missing[@]}"
}

cache_has() {
  grep --quiet --line-regexp --fixed-strings "$1" "$build/CMakeCache.txt" 2>/dev/null
}

configure() {
  local option start=() needed=no
  if ! [[ -f "$build/build.ninja" ]] || ! cache_has "CMAKE_HOME_DIRECTORY:INTERNAL=$root"; then
    start=(--fresh -G Ninja -DBUILD_TESTING:BOOL=OFF)
    needed=yes
  fi
  for option in "${options[@]}"; do
    cache_has "$option" || needed=yes
  done
  [[ $needed == yes ]] || return 0
  echo "Configuring $build"
  cmake "${start[@]}" "${options[@]/#/-D}" -S "$root" -B "$build" >>"$log" 2>&1 ||
    fail_with_log "the configuration failed (what Debian 13 needs stands in README, under Known limits)"
}

build_all() {
  NINJA_STATUS='[%p] ' cmake --build "$build" 2>&1 | show_progress 'Building' ||
    fail_with_log "the build failed"
}

fail_with_log() {
  tail -n 40 "$log" >&2
  fail "$1; the last lines are above, all of it is in $log"
}

# Two at once would write into each other's build; it is open to one of them until that ends.
open_build() {
  local lock="$build/setup.lock"
  { mkdir -p "$build" && : >>"$lock" && : >>"$log"; } 2>/dev/null ||
    fail "cannot write to $build; was it made by another user, or with sudo?"
  exec 9>>"$lock"
  flock --nonblock 9 || {
    echo "Waiting for another set-up in $build"
    flock 9
  }
  : >"$log"
}

read_arguments "$@"
choose_build
open_build
install_missing
configure
build_all
