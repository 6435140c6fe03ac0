#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests. Arguments go to ctest (`ctest --help`): tests/run.sh -R Chain
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
[[ ${1:--} == -* ]] || refuse_argument "\"$1\" is no option of ctest; tests of a name are run by -R $1"

install_packages
# ctest passes over options that it does not know.
options=$(ctest --help)
for argument in "$@"; do
  [[ $argument != -* || $argument =~ ^-j[0-9]+$ ]] || grep -qE -- "(^|[ ,])${argument%%=*}([ ,=]|\$)" <<<"$options" ||
    refuse_argument "\"$argument\" is no option of ctest"
done
build_in release all
# One more than there are cores: a quarter of the time is spent waiting for browsers, servers and clocks.
ctest --test-dir "$root/build" --output-on-failure -j "$(($(nproc) + 1))" "$@"
