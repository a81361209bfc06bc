#!/usr/bin/env bash
# Installs Debian's slurm-wlm as a cluster of one node on loopback and runs a small simulated fleet through the workflow.
#
#     sudo workflows/slurm/one-node.sh FOLDER [PROTOTYPES]
#
# FOLDER gets the fleet, the runs and the log; the default is 4 prototypes. Needs root (munge, slurmd), and `snakemake`
# and `debist` on the PATH (`make workflow`). Works in a container without systemd and cgroups: processes are tracked
# through /proc, tasks are not bound to cores, accounting is off. The daemons end with the script.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
count=${2:-4}
workflows=$(cd "$(dirname "$0")/.." && pwd)
state=$(mktemp -d)
node=$(hostname -s)

command -v slurmctld >/dev/null && command -v munged >/dev/null ||
    { apt-get -qq update && apt-get -qq install -y --no-install-recommends slurm-wlm munge; } >/dev/null

# Where every Slurm command looks; what a job inherits of the environment is up to the site.
conf=/etc/slurm/slurm.conf
[ -e "$conf" ] && { echo "$conf exists: this machine has a cluster already" >&2; exit 1; }
cat >"$conf" <<CONF
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket=$state/munge.socket
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MinJobAge=300
StateSaveLocation=$state/ctld
SlurmdSpoolDir=$state/d
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd.pid
SlurmctldLogFile=$state/slurmctld.log
SlurmdLogFile=$state/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
SlurmdParameters=config_overrides
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(getconf _NPROCESSORS_ONLN) RealMemory=4000 State=UNKNOWN
PartitionName=debist Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
mkdir -p "$state/ctld" "$state/d"

munged_pid=; ctld_pid=; slurmd_pid=
finish() {
    for pid in $slurmd_pid $ctld_pid $munged_pid; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$state" "$conf"
}
trap finish EXIT

dd if=/dev/urandom of="$state/munge.key" bs=1024 count=1 status=none
chmod 700 "$state" && chmod 400 "$state/munge.key"
munged --foreground --force --key-file="$state/munge.key" --socket="$state/munge.socket" \
    --pid-file="$state/munged.pid" --log-file="$state/munged.log" --seed-file="$state/munged.seed" 2>/dev/null & munged_pid=$!
until [ -S "$state/munge.socket" ]; do sleep 0.2; done
slurmctld -D 2>/dev/null & ctld_pid=$!
slurmd -D -N "$node" 2>/dev/null & slurmd_pid=$!
for _ in $(seq 100); do
    [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && break
    sleep 0.3
done
sinfo

cd "$folder"
[ -d prototypes ] || debist rig fleet "$count" -o prototypes --kind same --rate 2000 --duration 12 --seed 1 2>/dev/null
for settings in prototypes/*/*.toml; do # what is shown here is the cluster, not the models
    grep -q '^\[identify\]' "$settings" || printf '\n[identify]\nmodels = ["rbf-paper"]\n[compare]\nmodels = []\n' >>"$settings"
done
run() {
    snakemake -s "$workflows/Snakefile" --profile "$workflows/profiles/slurm" --config report=False \
        --group-components prototype=2 --default-resources slurm_partition=debist mem_mb=800 runtime=10 cpus_per_task=1 \
        --slurm-no-account --slurm-status-command squeue --slurm-init-seconds-before-status-checks 5 "$@"
}
run
squeue --states=all --Format="JobID:8,Name:40,State:12,TimeUsed:8,NodeList:12"
run --dry-run
cat runs/fleet.csv | head -5
