# A Slurm of one node, for the current user and on loopback alone, in the folder $slurm. Sourced; nothing of the machine's own
# Slurm is used. start_slurm CPUS returns 77, with the reason on standard output, where it cannot run here. munged wants every
# folder above $slurm to be open to all (mode 755).

PATH=$PATH:/usr/sbin:/sbin

free_port() {
    port=$((20000 + ($$ * 7 + ${port:-0}) % 10000))
    while grep -qi ":$(printf %04X "$port") " /proc/net/tcp /proc/net/tcp6 2>/dev/null; do port=$((port + 1)); done
    echo "$port"
}

write_slurm_conf() {
    controller_port=$(free_port)
    node_port=$((controller_port + 1))
    cat > "$slurm/slurm.conf" <<END
ClusterName=private
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$controller_port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
# A task that is queued again waits until the credential of its last run expires: 120 s, or 5 at least.
AuthInfo=socket=$slurm/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,requeue_delay=0
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
KillWait=2
ReturnToService=2
SlurmdTimeout=120
InactiveLimit=0
NodeName=here NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$node_port CPUs=$1 RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=here Default=YES State=UP MaxTime=INFINITE
END
    export SLURM_CONF="$slurm/slurm.conf"
}

start_node() {
    slurmd -D -N here >> "$slurm/slurmd.out" 2>&1 &
    node=$!
}

# slurm_comes PID COMMAND...: waits at most 20 s for the command to succeed, while the process lives.
slurm_comes() {
    daemon=$1 tries=0
    shift
    until "$@" > /dev/null 2>&1; do
        tries=$((tries + 1))
        kill -0 "$daemon" 2>/dev/null && [ "$tries" -lt 200 ] || return 1
        sleep 0.1
    done
}

node_is_idle() { [ "$(sinfo -h -o %t)" = idle ]; }

start_slurm() {
    for program in munged slurmctld slurmd sbatch; do
        command -v "$program" > /dev/null ||
            { echo "SKIPPED: $program is not installed; ./tests/run installs munge and slurm-wlm"; return 77; }
    done
    mkdir -p "$slurm/state" "$slurm/spool"
    (umask 077 && head -c 1024 /dev/urandom > "$slurm/munge.key")
    munged --foreground --socket="$slurm/munge.socket" --key-file="$slurm/munge.key" --num-threads=1 \
        --pid-file="$slurm/munged.pid" --log-file="$slurm/munged.log" --seed-file="$slurm/munged.seed" \
        > "$slurm/munged.out" 2>&1 &
    munged=$!
    slurm_comes $munged munge -n --socket="$slurm/munge.socket" ||
        { echo "SKIPPED: munged does not run here:"; cat "$slurm/munged.out"; return 77; }
    write_slurm_conf "$1"
    slurmctld -D > "$slurm/slurmctld.out" 2>&1 &
    controller=$!
    start_node
    slurm_comes $controller node_is_idle ||
        { echo "SKIPPED: Slurm does not run here:"; tail -n 5 "$slurm"/slurm*.out; return 77; }
}

# Ends what runs of jobs, too.
stop_slurm() {
    scancel --me --full --signal=KILL > /dev/null 2>&1 || true
    for daemon in ${node:-} ${controller:-} ${munged:-}; do
        kill "$daemon" 2>/dev/null || true
        wait "$daemon" 2>/dev/null || true
    done
}
