# Sourced by app/run.sh, tests/run.sh and .ci/run: installs the packages that are missing and builds.
# Needs `root`, the source folder. Says nothing and does nothing where all is there already.

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
  echo "installing" $missing >&2
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >&2
}

# build_in FOLDER TARGET [cmake options]: configures once, then builds what has changed. Several sources are
# compiled as one, in half the time from nothing. A build of one's own (`cmake -B`) compiles each alone.
build_in() {
  local folder="$1" target="$2"
  shift 2
  if [ ! -f "$folder/build.ninja" ]; then
    cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_UNITY_BUILD=ON "$@" >&2
  fi
  # Says nothing where nothing has to be done.
  ninja -C "$folder" "$target" |
    { grep --line-buffered -vE 'Entering directory|Re-checking globbed|no work to do' || true; } >&2
}
