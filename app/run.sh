#!/usr/bin/env bash
# Installs what is missing, builds, and runs quicksand with the given arguments; without arguments it
# runs the demo. Paths are relative to the folder it is called from.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/setup.sh"

install_packages
if [ "${1:-}" = window ]; then
  install_packages window
  # An earlier configuration may have found no SDL.
  [ -f "$root/build/quicksand_window.so" ] || rm -f "$root/build/build.ninja"
  build_in release quicksand_window
fi
build_in release quicksand

if [ $# -eq 0 ]; then
  set -- run "$root/assets/scenes/collapse.json" --overwrite
fi
# Memory in huge pages, where the system gives them to who asks: large systems are through a step sooner.
export GLIBC_TUNABLES=${GLIBC_TUNABLES:-glibc.malloc.hugetlb=1}
# The name under which the program tells how to go on.
export QUICKSAND_COMMAND=$0
exec "$root/build/quicksand" "$@"
