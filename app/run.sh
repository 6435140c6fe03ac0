#!/usr/bin/env bash
# Installs what is missing, builds, and runs quicksand with the given arguments; without arguments it
# runs the demo. Paths are relative to the folder it is called from.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/setup.sh"

install_packages
build_in "$root/build" quicksand -DCMAKE_BUILD_TYPE=Release

if [ $# -eq 0 ]; then
  set -- run "$root/assets/scenes/collapse.json"
fi
exec "$root/build/quicksand" "$@"
