# Sourced by the scripts: installs the packages that are missing, builds, and answers --help.
# Needs `root`, the source folder. Says nothing and does nothing where all is there already.

# answer_help ARGUMENTS...: where the first one asks for help, prints the comment at the head of the script and ends it.
answer_help() {
  case ${1:-} in -h | --help) ;; *) return 0 ;; esac
  awk 'NR > 1 { if (!sub(/^# ?/, "")) exit; print }' "$0"
  exit 0
}

# refuse_argument TEXT: ends the script with exit code 2.
refuse_argument() {
  echo "$(basename "$0"): $1; --help tells what there is" >&2
  exit 2
}

# expect_number NAME TEXT
expect_number() { [[ $2 =~ ^[0-9]+$ ]] || refuse_argument "$1 must be a whole number, not \"$2\""; }

# expect_at_most COUNT ARGUMENTS...
expect_at_most() { [ $# -le $(($1 + 1)) ] || refuse_argument "\"${*: -1}\" is one argument too many"; }

# install_packages [mark]: the unmarked packages of packages.txt and those with that mark.
install_packages() {
  local mark="${1:-}" wanted missing
  wanted=$(sed 's/#.*//' "$root/app/packages.txt" |
           awk -v mark="$mark" 'NF == 1 || (NF == 2 && $2 == mark) { print $1 }')
  # dpkg-query complains about unknown packages and lists the installed ones.
  missing=$(comm -23 <(sort <<<"$wanted") \
    <(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null |
      awk '$1 == "ii" { print $2 }' | sort -u))
  [ -z "$missing" ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "quicksand needs these packages; ask an administrator to install them:" $missing >&2
      return 1
    fi
    as_root=(sudo)
  fi
  local log
  log=$(mktemp "${TMPDIR:-/tmp}/quicksand-install-XXXXXX.log")
  "${as_root[@]}" apt-get update -qq >"$log" 2>&1 || package_failure "$log" || return
  echo "Installing" $missing >&2
  "${as_root[@]}" apt-get install --assume-no --no-install-recommends $missing 2>/dev/null |
    grep -E '^(Need to get|After this operation)' >&2 || true
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >>"$log" 2>&1 ||
    package_failure "$log" || return
  rm -f "$log"
}

# package_failure LOG: tells the end of what the package manager said, and where the rest is.
package_failure() {
  echo "The packages could not be installed; the last lines of $1:" >&2
  tail -5 "$1" >&2
  return 1
}

# build_in PRESET TARGET [cmake options]: configures once by a preset of CMakePresets.json, then builds what has
# changed; $build is the folder.
build_in() {
  local preset="$1" target="$2" log
  shift 2
  build="$root/build"
  [ "$preset" = release ] || build="$root/build-$preset"
  log="$build/build.log"
  mkdir -p "$build"
  if [ ! -f "$build/build.ninja" ]; then
    (cd "$root" && cmake --preset "$preset" "$@") >"$log" 2>&1 || build_failure "$log" || return
  fi
  # On a terminal ninja keeps to one line, which is wiped off in the end; elsewhere the log has what was done.
  if [ -t 2 ]; then
    NINJA_STATUS='building quicksand: %f of %t, %e s  ' ninja -C "$build" "$target" >&2 || return
  else
    ninja -C "$build" -n "$target" | grep -q 'no work to do' || echo "Building quicksand ($preset)" >&2
    ninja -C "$build" "$target" >"$log" 2>&1 || build_failure "$log" || return
  fi
}

# build_failure LOG: what went wrong, without what went well.
build_failure() {
  grep -vE '^\[[0-9]+/[0-9]+\]' "$1" | head -60 >&2
  echo "The build failed; all of it is in $1" >&2
  return 1
}
