#!/usr/bin/env bash
# Runs a command beside a Slurm of its own: munged, slurmctld and slurmd on loopback, with key,
# configuration, state and logs in a temporary folder. All three end with the command, however it ends.
# Exits with what the command exits with; 77 and a reason where Slurm cannot be started at all.
#   tests/support/local_slurm.sh sbatch --wait --wrap hostname
set -uo pipefail
PATH="$PATH:/usr/sbin:/sbin"

skip() { echo "skipped: $1" >&2; exit 77; }
for program in munged slurmctld slurmd sbatch sinfo; do
  command -v "$program" >/dev/null ||
    skip "$program is not installed (Debian: slurm-wlm, munge)"
done
[ "$(id -u)" -eq 0 ] || skip "only root can start slurmd"

here=$(mktemp -d /tmp/quicksand_slurm_XXXXXX)
chmod 755 "$here"  # munge refuses a socket that others cannot reach
daemons=()
# Each is known by its own process number; no other Slurm of this machine is touched.
finish() {
  local process
  for process in "${daemons[@]}"; do kill -TERM "$process" 2>/dev/null; done
  for process in "${daemons[@]}"; do
    for _ in $(seq 50); do kill -0 "$process" 2>/dev/null || break; sleep 0.1; done
    kill -KILL "$process" 2>/dev/null
    wait "$process" 2>/dev/null
  done
  rm -rf "$here"
}
trap finish EXIT
trap 'exit 143' TERM
trap 'exit 130' INT

give_up() {
  echo "local_slurm.sh: $1" >&2
  tail -n 20 "$here"/*.log >&2
  exit 1
}

free_port() {
  local port
  while port=$((20000 + RANDOM % 10000)); (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do :; done
  echo "$port"
}

# start NAME COMMAND...
start() {
  local name="$1"
  shift
  "$@" >"$here/$name.out.log" 2>&1 &
  daemons=($! "${daemons[@]}")  # the last one started ends first
}

# until_true SECONDS COMMAND...
until_true() {
  local left=$(($1 * 10))
  shift
  while ! "$@" >/dev/null 2>&1; do
    [ $((left--)) -gt 0 ] || return 1
    sleep 0.1
  done
}

head -c 1024 /dev/urandom >"$here/munge.key"
chmod 600 "$here/munge.key"
mkdir "$here/state" "$here/spool"
host=$(hostname -s)
export SLURM_CONF="$here/slurm.conf"
cat >"$SLURM_CONF" <<CONF
ClusterName=quicksand
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$here/munge.socket
CredType=cred/munge
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_min_interval=1,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=here Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF

start munged munged --foreground --force --key-file="$here/munge.key" --num-threads=2 \
  --socket="$here/munge.socket" --pid-file="$here/munged.pid" --log-file="$here/munged.log" \
  --seed-file="$here/munge.seed"
until_true 5 test -S "$here/munge.socket" || give_up "munged did not start"
start slurmctld slurmctld -D -i
start slurmd slurmd -D
until_true 15 sh -c 'sinfo -h -o %t | grep -q idle' || give_up "no node became idle"

"$@"
