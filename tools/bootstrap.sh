# Sourced by ./run and ./test: installs what is missing and builds. Talks on standard error only.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf 'waywright: %s\n' "$*" >&2; }

# missing_packages LIST: packages of a list in tools/ that are not installed.
missing_packages() {
  local name
  grep -v '^#' "$root/tools/$1" | while read -r name; do
    [ -n "$name" ] || continue
    dpkg-query -W -f='${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed || printf '%s ' "$name"
  done
}

# install_missing [LIST]
install_missing() {
  local missing
  missing=$(missing_packages "${1:-packages.txt}")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" != 0 ]; then
    say "these packages are missing, and installing them needs root: $missing"
    exit 2
  fi
  say "installing $missing"
  local log
  log=$(mktemp)
  export DEBIAN_FRONTEND=noninteractive
  # shellcheck disable=SC2086
  if ! apt-get install -y --no-install-recommends $missing >"$log" 2>&1; then
    if ! { apt-get update && apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
      tail -n 5 "$log" >&2
      say "these packages are missing and could not be installed (is there a network?): $missing"
      rm -f "$log"
      exit 2
    fi
  fi
  rm -f "$log"
}

# build PRESET TARGET…: configures where needed, builds, prints only when it fails or takes work.
build() {
  local preset=$1
  shift
  local dir="$root/build/$preset"
  if [ ! -f "$dir/build.ninja" ]; then
    install_missing
    say "configuring $dir"
    local log
    log=$(mktemp)
    if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1; then
      tail -n 20 "$log" >&2
      rm -f "$log"
      say "configuring failed"
      exit 2
    fi
    rm -f "$log"
  fi
  local log announcer
  log=$(mktemp)
  { sleep 2 >/dev/null 2>&1 && say "building $dir (a few minutes the first time)"; } &
  announcer=$!
  if ! ninja -C "$dir" "$@" >"$log" 2>&1; then
    kill "$announcer" 2>/dev/null
    grep -vE '^\[[0-9]+/[0-9]+\]' "$log" | tail -n 60 >&2
    rm -f "$log"
    say "the build failed"
    exit 2
  fi
  kill "$announcer" 2>/dev/null
  wait "$announcer" 2>/dev/null
  rm -f "$log"
}
