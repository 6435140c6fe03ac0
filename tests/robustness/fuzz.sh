#!/usr/bin/env bash
# Feeds every reader with damaged files for so many seconds: `tests/robustness/fuzz.sh 600 [SEED]`.
# Inputs that crash, hang, take too much memory or fail in another way than an input error are saved in
# out/fuzz; exit code 1 then.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
build_in "$root/build" quicksand_fuzz -DCMAKE_BUILD_TYPE=Release
mkdir -p "$root/out/fuzz"
# A disk would take most of the time.
[ -w /dev/shm ] && export TMPDIR=/dev/shm
"$root/build/tests/robustness/quicksand_fuzz" --seconds "${1:-600}" --seed "${2:-$$}" --save "$root/out/fuzz"
