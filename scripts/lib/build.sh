# shellcheck shell=bash
# Builds the release for scripts/blossom and scripts/test.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
# shellcheck source=scripts/lib/packages.sh
source "$root/scripts/lib/packages.sh"

# Exit status when the build fails (EX_SOFTWARE of sysexits.h).
readonly exit_build_failed=70

readonly root build="$root/build/release"

# One build at a time; a second caller waits. The lock lasts until unlock_build or the end of the process.
lock_build() {
  mkdir -p "$build"
  exec 9>>"$build/.lock"
  if ! flock --nonblock 9; then
    echo "blossom: waiting for another build" >&2
    flock 9
  fi
}

unlock_build() {
  exec 9>&-
}

# is_configured WITH_TESTS: whether the build is configured for this checkout, which may have been moved or copied, and for tests and the
# Python module if WITH_TESTS.
is_configured() {
  [[ -f $build/build.ninja ]] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt" &&
    { [[ $1 == OFF ]] || [[ $(grep -cxE "BLOSSOM_BUILD_(TESTS|PYTHON):BOOL=ON" "$build/CMakeCache.txt") == 2 ]]; }
}

is_up_to_date() {
  [[ $(cd "$build" && ninja -n "$1" 2>&1) == "ninja: no work to do." ]]
}

configure_and_build() {
  if ! is_configured "$2"; then
    (cd "$root" && cmake --fresh --preset release -DBLOSSOM_BUILD_TESTS="$2" -DBLOSSOM_BUILD_PYTHON="$2") || return
  fi
  cmake --build "$build" --target "$1"
}

# build_release TARGET WITH_TESTS: brings TARGET up to date. Writes to stderr, and only if there is something to do.
build_release() {
  local log="$build/last-build.log" groups=build
  [[ $2 == ON ]] && groups="build test"
  if ! command -v flock >/dev/null; then
    require_packages "$groups"
  fi
  lock_build
  if ! is_configured "$2" || ! is_up_to_date "$1"; then
    require_packages "$groups"
    echo "blossom: building; the first time takes a few minutes" >&2
    if ! configure_and_build "$1" "$2" >"$log" 2>&1 </dev/null; then
      tail -n 40 "$log" >&2
      echo "blossom: the build failed; all of it is in $log" >&2
      exit "$exit_build_failed"
    fi
  fi
  unlock_build
}
