#!/usr/bin/env bash
# Searches for inputs that a reader neither reads nor refuses: `tests/robustness/fuzz.sh SECONDS [READER...]`
# gives each reader so many seconds (600) of libFuzzer under the address and undefined-behaviour sanitizers,
# one a core. What crashes, hangs, takes too much memory or fails otherwise than by an input error is saved in
# out/fuzz/findings/READER; exit code 1 then. Mended, it belongs into cases/READER, which the tests read.
# The next search goes on from the inputs that this one has collected in out/fuzz/READER.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/setup.sh"
answer_help "$@"
seconds=${1:-600}
expect_number SECONDS "$seconds"
[ $# -gt 0 ] && shift
all=(scene campaign session line message options checkpoint history)
readers=("$@")
[ ${#readers[@]} -gt 0 ] || readers=("${all[@]}")
for reader in "${readers[@]}"; do
  [[ " ${all[*]} " == *" $reader "* ]] || refuse_argument "there is no reader \"$reader\", only ${all[*]}"
done

command -v clang++ >/dev/null || install_packages ci
build_in fuzz fuzzers
binaries="$build/tests/robustness"
out="$root/out/fuzz"
rm -rf "$out/findings"
mkdir -p "$out"
# A disk would take most of the time.
[ -w /dev/shm ] && export TMPDIR=/dev/shm
"$binaries/fuzz_seeds" "$out"

# search READER: ends at the first finding.
search() {
  local reader="$1" log="$out/$1.log" outcome="no finding"
  local cases="$root/tests/robustness/cases/$reader"
  mkdir -p "$out/findings/$reader" "$cases"
  "$binaries/fuzz_$reader" "$out/$reader" "$cases" -dict="$out/$reader.dict" \
    -artifact_prefix="$out/findings/$reader/" -max_total_time="$seconds" -max_len=32768 \
    -timeout=20 -rss_limit_mb=3072 -malloc_limit_mb=1024 -print_final_stats=1 >"$log" 2>&1 ||
    outcome="FINDING, see $log"
  rmdir "$out/findings/$reader" "$cases" 2>/dev/null || true
  printf '%-10s %9s executions, %5s edges, %4s MB at most: %s\n' "$reader" \
    "$(awk '/number_of_executed_units/ { print $2 }' "$log")" \
    "$(grep -o ' cov: [0-9]*' "$log" | awk 'END { print $2 }')" \
    "$(awk '/peak_rss_mb/ { print $2 }' "$log")" "$outcome"
}
export -f search
export out root binaries seconds
printf '%s\n' "${readers[@]}" | xargs -P "$(nproc)" -I{} bash -c 'search {}'
[ -z "$(find "$out/findings" -type f)" ]
