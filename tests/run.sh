#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. Arguments go to ctest: tests/run.sh -R Chain
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/setup.sh"

install_packages
build_in release all
ctest --test-dir "$root/build" --output-on-failure -j "$(nproc)" "$@"
