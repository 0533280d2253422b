#!/usr/bin/env bats
# The rows of an ensemble on several hosts: over ssh to hosts in network namespaces of the test's own, and as a Slurm array job on
# a single-node Slurm that the test starts. Needs root and Debian's openssh-server; slurmctld, slurmd, slurm-client and munge.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

setup() {
  cd "$BATS_TEST_TMPDIR" || return
  command -v parallel >/dev/null || skip "GNU parallel is not installed"
  [[ $(id -u) -eq 0 ]] || skip "not root: no network namespaces, no daemons"
  started=()
}

teardown() {
  local pid host
  for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
  for host in 1 2; do ip netns del "soilweave$host" 2>/dev/null || true; done
}

needs() {
  local program
  for program in "$@"; do
    command -v "$program" >/dev/null || [[ -x /usr/sbin/$program ]] || skip "$program is not installed"
  done
}

ensemble() {
  pack-generate --grains 200 --pressure 1e4 --void-ratio 0.8 --seed 1 --quiet --force -o packing.h5
  {
    printf 'id [1]\tE [Pa]\tnu [1]\tkr [1]\teta [1]\tmu [deg]\n'
    for k in 0 1 2 3 4 5; do printf '%s\t4e9\t0.2\t0.1\t0.2\t2%s\n' $k $k; done
  } > sets.tsv
  "$ROOT/pipelines/calibration/ensemble.sh" sets.tsv case hm packing.h5 "$ROOT/pipelines/calibration/hertz-mindlin.toml" 0.1 0.4
}

complete() {
  [[ $(find case/runs -name series.h5 | wc -l) -eq 6 ]] || show "not all rows are there: $(find case \( -name failed -o -name log \) -exec cat {} +)"
}

@test "rows go to the hosts of SSHLOGINFILE" {
  needs sshd ssh-keygen ip
  ip netns add soilweave1 2>/dev/null || skip "network namespaces are not permitted"
  ip netns add soilweave2
  ssh-keygen -q -t ed25519 -N '' -f key
  ssh-keygen -q -t ed25519 -N '' -f hostkey
  cp key.pub authorized
  mkdir -p /run/sshd
  local host
  for host in 1 2; do
    ip link add "sw$host" type veth peer name eth0 netns "soilweave$host"
    ip addr add "10.231.$host.1/30" dev "sw$host"
    ip link set "sw$host" up
    ip -n "soilweave$host" addr add "10.231.$host.2/30" dev eth0
    ip -n "soilweave$host" link set eth0 up
    ip -n "soilweave$host" link set lo up
    printf '%s\n' "ListenAddress 10.231.$host.2" "HostKey $PWD/hostkey" "AuthorizedKeysFile $PWD/authorized" 'StrictModes no' 'UsePAM no' \
      'PermitRootLogin prohibit-password' 'PidFile none' > "sshd$host.conf"
    ip netns exec "soilweave$host" /usr/sbin/sshd -D -f "$PWD/sshd$host.conf" 2> "sshd$host.log" 3>&- &
    # shellcheck disable=SC2030  # each test is a shell of its own
    started+=($!)
    printf '1/ssh -i %s -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR 10.231.%s.2\n' "$PWD/key" "$host" >> hosts
  done
  sleep 1
  SSHLOGINFILE=$PWD/hosts JOBS=1 exits 0 ensemble
  complete
  for host in 1 2; do grep -q "10\.231\.$host\.2" case/sets.joblog || show "host $host had no row: $(cat case/sets.joblog)"; done
}

@test "ENGINE=slurm: the same rows as an array job, and again those that are lost" {
  needs slurmctld slurmd sbatch munged mungekey
  mkdir -p slurm munge
  chmod 711 . munge
  mungekey --create --keyfile="$PWD/munge/key"
  munged --foreground --force --key-file="$PWD/munge/key" --socket="$PWD/munge/socket" --pid-file="$PWD/munge/pid" --seed-file="$PWD/munge/seed" 2> munge/log 3>&- &
  # shellcheck disable=SC2031  # each test is a shell of its own
  started+=($!)
  local name
  name=$(hostname)
  cat > slurm/slurm.conf <<CONF
ClusterName=soilweave
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$PWD/munge/socket
CryptoType=crypto/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MaxArraySize=4
StateSaveLocation=$PWD/slurm/state
SlurmdSpoolDir=$PWD/slurm/spool
SlurmctldPidFile=$PWD/slurm/slurmctld.pid
SlurmdPidFile=$PWD/slurm/slurmd.pid
SlurmctldLogFile=$PWD/slurm/slurmctld.log
SlurmdLogFile=$PWD/slurm/slurmd.log
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$name Default=YES MaxTime=INFINITE State=UP
CONF
  mkdir -p slurm/state slurm/spool
  export SLURM_CONF=$PWD/slurm/slurm.conf
  sleep 1
  /usr/sbin/slurmctld -D > slurm/slurmctld.out 2>&1 3>&- &
  # shellcheck disable=SC2031  # each test is a shell of its own
  started+=($!)
  /usr/sbin/slurmd -D > slurm/slurmd.out 2>&1 3>&- &
  # shellcheck disable=SC2031  # each test is a shell of its own
  started+=($!)
  local k
  for k in $(seq 10); do [[ $(timeout 2 sinfo --noheader --format %t 2>/dev/null) == idle ]] && break; sleep 0.5; done
  [[ $(timeout 2 sinfo --noheader --format %t 2>/dev/null) == idle ]] || skip "Slurm's node does not come up here: $(tail -n 2 slurm/slurmd.log)"
  export ENGINE=slurm SLURM_POLL=1 SLURM_ARRAY_SIZE=4
  exits 0 ensemble
  complete
  rm -r case/runs/000003
  exits 0 ensemble
  [[ $output == *"1 of 6 rows"* ]] || show
  complete
}
