#!/bin/sh
# farm_test.sh RUSHLIGHT MOVING_SCENE SOURCE_DIR: a shot as a job array of a private Slurm, whose tasks are cancelled, killed,
# queued again and lose their node in the middle; its frames must be those of one run, and no finished one drawn twice.
set -eu
tool=$1 moving_scene=$2 source=$3
work=$(mktemp -d "${TMPDIR:-/tmp}/rushlight-farm-XXXXXX")
chmod 755 "$work"
slurm=$work/slurm
. "$source/tests/farm/private_slurm.sh"
trap 'stop_slurm; rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work"

fail() {
    echo "FAILED: $*"
    sinfo 2>&1 || true
    squeue -a 2>&1 || true
    for log in "$work"/shot-*.log "$slurm/slurmctld.log"; do echo "--- $log"; tail -n 30 "$log"; done
    exit 1
}

# Waits at most 100 s for a command, called $1 in the message.
await() {
    what=$1 tries=0
    shift
    until "$@"; do
        tries=$((tries + 1))
        [ "$tries" -lt 1000 ] || fail "$what: not in 100 s"
        sleep 0.1
    done
}

frame() { printf '%s/shot_%04d.png' "$1" "$2"; }

exist() { for number in "$@"; do [ -f "$(frame shot "$number")" ] || return 1; done; }

# A renderer comes so far and no further: it waits for a reader of the pipe that its frame is to be written into.
block() { for number in "$@"; do mkfifo "$(frame shot "$number")"; done; }
unblock() { for number in "$@"; do rm "$(frame shot "$number")"; done; }

# What tells a file from another one with the same name and bytes.
identities() { for number in "$@"; do stat -c '%n %i %y' "$(frame shot "$number")"; done; }

parent() { sed -n 's/^PPid:[[:space:]]*//p' "/proc/$1/status"; }

field() { scontrol show job "${job}_$1" -o | tr ' ' '\n' | sed -n "s/^$2=//p"; }

queue_is_empty() { [ -z "$(squeue -h -a -t PD,R,CG,S)" ]; }

submit() {
    rm -f pid.*
    job=$(sbatch --parsable --array=1-4 "$source/sandbox/farm/shot.sbatch" scene/moving.gltf \
        'shot/shot_%04d.png' 0-23 $options) || fail "sbatch"
}

start_slurm 2 || exit $?
"$moving_scene" "$source/content/testcard" scene
options="--animation 0 --fps 8 --size 96x64 --light-shadows on --exposure auto"
mkdir shot
# shellcheck disable=SC2086  # words on purpose
"$tool" capture scene/moving.gltf -o 'whole/shot_%04d.png' --frames 0-23 $options || fail "one run"
# shellcheck disable=SC2086
"$tool" capture scene/moving.gltf -o 'shot/shot_%04d.png' --frames 18-18 $options --tonemap aces || fail "other options"
head -c 300 "$(frame whole 4)" > "$(frame shot 4)"
cmp -s "$(frame whole 2)" "$(frame whole 3)" && fail "nothing moves"

printf '#!/bin/sh\necho $$ > "%s/pid.$SLURM_ARRAY_TASK_ID"\nexec "%s" "$@"\n' "$work" "$tool" > noting_its_pid
chmod +x noting_its_pid
export RUSHLIGHT="$work/noting_its_pid"

# Cancelled: it stays so.
block 1 7
submit
await "the first frames" exist 0 6
scancel "$job"
await "the end of a cancelled job" queue_is_empty
[ "$(field 1 JobState)" = CANCELLED ] || fail "cancelled, it is $(field 1 JobState)"
[ "$(field 1 Restarts)" = 0 ] || fail "cancelled, it ran again"
unblock 1 7
kept=$(identities 0 6)

# Submitted again: the renderer of task 1 is killed, task 2 queued again by the operator.
block 3 9 15 21
submit
await "frames of tasks 1 and 2" exist 0 1 2 6 7 8
kept="$kept
$(identities 1 2 7 8)"
unblock 3 9
kill -KILL "$(cat pid.1)"
scontrol requeue "${job}_2" || fail "scontrol requeue"

# The node of tasks 3 and 4 dies and comes back.
await "frames of tasks 3 and 4" exist 12 13 14 18 19 20
kept="$kept
$(identities 12 13 14 18 19 20)"
unblock 15 21
dead=$node
for task in 3 4; do
    renderer=$(cat "pid.$task")
    script=$(parent "$renderer")
    dead="$dead $(parent "$script") $script $renderer"
done
# shellcheck disable=SC2086
kill -KILL $dead
wait "$node" 2>/dev/null || true
# Slurm would see for itself when the node had been silent for SlurmdTimeout; the operator sees it at once.
scontrol update NodeName=here State=DOWN Reason=dead || fail "scontrol update"
start_node

await "the end of the shot" queue_is_empty
for task in 1 2 3 4; do
    [ "$(field $task JobState)" = COMPLETED ] || fail "task $task is $(field $task JobState)"
    [ "$(field $task Restarts)" = 1 ] || fail "task $task was started again $(field $task Restarts) times"
done
grep -q "signal 9 ended shard 1" "shot-${job}_1.log" || fail "task 1 does not say what happened"
number=0
while [ $number -lt 24 ]; do
    cmp "$(frame whole $number)" "$(frame shot $number)" || fail "frame $number is not that of one run"
    number=$((number + 1))
done
[ "$kept" = "$(identities 0 6 1 2 7 8 12 13 14 18 19 20)" ] || fail "finished frames were drawn again"
echo "24 frames, the same as those of one run"
