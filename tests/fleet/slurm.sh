#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# docs/scale.md's Slurm array for real: two nodes on one machine, an array over the shards of `validate` and
# `simulate`, a node that loses power while it works, and its task requeued to the other. The merged results must
# be the bytes that one machine writes.
#
#   tests/fleet/slurm.sh build/quick/rigor build/quick/fleet
#
# Exit code 77: skipped, for lack of Slurm or of root.
set -euo pipefail

rigor=$(realpath "$1")
work=$(realpath -m "$2")
array=$(realpath "$(dirname "$0")/array.sbatch")
shards=6
models=${RIGOR_FLEET_MODELS:-300}
limit=${RIGOR_FLEET_SECONDS:-480}  # of the whole array: it hangs beyond

skip() { echo "the fleet is not tested: $1"; exit 77; }
fail() { echo "FAILED: $1"; tail -n 30 "$work"/log/*; exit 1; }

for program in munged slurmctld slurmd sbatch scontrol squeue unshare; do
  command -v "$program" >/dev/null || skip "$program is not installed (Debian: apt install slurm-wlm)"
done
[ "$(id -u)" -eq 0 ] || skip 'slurmctld and slurmd need root here'
unshare --pid --fork --mount-proc true 2>/dev/null || skip 'no PID namespaces, which are the nodes'

rm -rf "$work"
mkdir -p "$work"/{state,log,models,one,parts}
pids=()
stop_all() {
  for pid in "${pids[@]}"; do kill -KILL "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
}
trap stop_all EXIT

# await SECONDS WHAT COMMAND...: until the command succeeds.
await() {
  local end=$((SECONDS + $1)) what=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || fail "waited in vain for $what"
    read -rt 0.1 <> <(:) || true
  done
}

# A box that falls and settles; every third one has a fault for `validate` to find.
make_model() {
  mkdir -p "$work/models/m$1"
  local inertia=0.0066
  [ $(($1 % 3)) -ne 0 ] || inertia=0.05
  cat >"$work/models/m$1/model.sdf" <<XML
<sdf version="1.9">
  <model name="m$1">
    <pose>0 0 0.$((10 + $1 % 20)) 0.1 0.2 0</pose>
    <link name="body">
      <inertial><mass>1</mass><inertia><ixx>0.0066</ixx><iyy>0.0066</iyy><izz>$inertia</izz></inertia></inertial>
      <collision name="box"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision>
      <visual name="box"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></visual>
    </link>
  </model>
</sdf>
XML
}
for ((i = 0; i < models; ++i)); do make_model "$i"; done

port=$((20000 + RANDOM % 20000))
host=$(hostname -s)
cat >"$work/slurm.conf" <<CONF
ClusterName=rigor
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldPort=$port
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=2
JobRequeue=1
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=fleet Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/slurm.conf"

mkdir "$work/spool-n1" "$work/spool-n2"
head -c 1024 /dev/urandom >"$work/munge.key"
chmod 400 "$work/munge.key"
munged --foreground --force --socket="$work/munge.socket" --key-file="$work/munge.key" \
  --seed-file="$work/munge.seed" --pid-file="$work/munged.pid" --log-file="$work/log/munged" &
pids+=($!)
await 10 'munge' munge --socket="$work/munge.socket" --no-input
slurmctld -D -i >"$work/log/slurmctld" 2>&1 &
pids+=($!)

# A node is all that runs in a PID namespace: when its first process is killed the kernel kills the rest, as if it
# had lost power.
start_node() {
  unshare --pid --fork --mount-proc --kill-child slurmd -D -N "$1" >"$work/log/$1" 2>&1 &
  node=$!
  pids+=("$node")
}
start_node n1
start_node n2
cut=$node
await 30 'two idle nodes' sh -c '[ "$(sinfo -h -N -t idle -o %N | sort -u | wc -l)" -eq 2 ]'

cd "$work"
job=$(RIGOR="$rigor" OUT="$work/parts" sbatch --parsable --array="1-$shards" \
  --output="$work/log/task-%a" "$array" models)
echo "array $job of $shards tasks on n1 and n2, $models models"

# In the middle: a task on n2 has written some of its simulations and still runs. The node is stopped while that is
# looked at, and goes on if the task was done.
running_on_n2() { squeue -h -r -j "$job" -w n2 -t R -o %K | head -n 1; }
processes_of_n2() {
  local space process
  space=$(readlink "/proc/$cut/ns/pid_for_children")
  for process in /proc/[0-9]*; do
    if [ "$(readlink "$process/ns/pid" 2>/dev/null)" = "$space" ]; then basename "$process"; fi
  done
}
is_in_the_middle() {
  local process processes
  task=$(running_on_n2)
  [ -n "$task" ] && [ -s "$work/parts/simulate-$task.jsonl" ] || return 1
  processes=$(processes_of_n2)
  kill -STOP $processes 2>/dev/null || true
  for process in $processes; do
    if tr '\0' ' ' 2>/dev/null <"/proc/$process/cmdline" | grep -q "simulate.*simulate-$task.jsonl"; then return 0; fi
  done
  kill -CONT $processes 2>/dev/null || true
  return 1
}
await "$limit" 'a task on n2' is_in_the_middle
kept=$(wc -l <"$work/parts/simulate-$task.jsonl")
kill -KILL "$cut"
echo "n2 lost power while it ran task $task, $kept simulations done"

await "$limit" 'a requeued task' sh -c "scontrol show job $job | grep -q 'Restarts=[1-9]'"
scontrol show job "$job" | grep -q "ArrayTaskId=$task " || fail "task $task is gone"
start_node n2  # repaired, it returns to service
await "$limit" 'the end of the array' sh -c "! squeue -h -j $job | grep -q ."
grep -q 'started again' "$work/log/task-$task" || fail "task $task was not run again"

for what in validate simulate; do
  "$rigor" merge parts/"$what"-*.jsonl -o "$what.jsonl" || fail "the parts of $what are not whole"
  "$rigor" "$what" models -j 1 --fail-on never --output "jsonl:one/$what.jsonl" >/dev/null 2>&1
  cmp "$what.jsonl" "one/$what.jsonl" || fail "$what differs from one machine's"
done
"$rigor" merge parts/*.jsonl -o fleet.sqlite
"$rigor" merge one/*.jsonl -o one.sqlite
cmp fleet.sqlite one.sqlite || fail "the database differs from one machine's"
echo "merged results are those of one machine, to the byte"
