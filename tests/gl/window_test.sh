#!/bin/sh
# window_test.sh CASE SANDBOX SOURCE_DIR WORK_DIR: runs the sandbox in a virtual display and watches what it does.
set -eu
case_name=$1 sandbox=$2 source=$3 work=$4
rm -rf "$work" && mkdir -p "$work" && cd "$work"
log=$work/log.txt
: > "$log"
display=$source/tests/support/with_display.sh

fail() { echo "FAILED: $*"; cat "$log"; exit 1; }

# Waits until the log has a line with $1, for at most 120 s, while the sandbox lives.
await() {
    tries=0
    until grep -q "$1" "$log"; do
        kill -0 "$pid" 2>/dev/null || fail "the sandbox ended before it said '$1'"
        tries=$((tries + 1))
        [ "$tries" -lt 1200 ] || fail "the sandbox did not say '$1'"
        sleep 0.1
    done
}

# Runs the sandbox on and on, at a small size, and waits for its first frame.
start() {
    "$display" sh -c 'echo $$ > pid; exec "$@"' run \
        "$sandbox" --size 160x90 --frames 1000000 "$@" > "$log" 2>&1 &
    server=$!
    until [ -s pid ]; do
        kill -0 "$server" 2>/dev/null || fail "the virtual display did not start"
        sleep 0.1
    done
    pid=$(cat pid)
    trap 'kill "$pid" 2>/dev/null || true' EXIT
    await "first frame"
}

stop() {
    kill "$pid" || fail "the sandbox did not survive"
    wait "$server" || true
}

case $case_name in
picture)
    "$display" "$sandbox" --size 320x180 --frames 3 --lit --screenshot frame.png > "$log" 2>&1 ||
        fail "exit code $?"
    "$(dirname "$sandbox")/picture_varies" frame.png 0.02 || fail "the picture is uniform"
    ;;
view)
    "$display" "$(dirname "$sandbox")/rushlight" view "$source/content/testcard/testcard.gltf" \
        --size 320x180 --frames 3 --screenshot frame.png > "$log" 2>&1 || fail "exit code $?"
    "$(dirname "$sandbox")/picture_varies" frame.png 0.02 || fail "the picture is uniform"
    ;;
broken_shader)
    cp -r "$source/shaders" shaders
    start --shaders "$work/shaders"
    cp shaders/passes/post/tonemap.frag kept.frag
    echo "this is no shader" >> shaders/passes/post/tonemap.frag
    await "error: .*tonemap"
    cp kept.frag shaders/passes/post/tonemap.frag
    await "shaders loaded again"
    stop
    ;;
broken_level)
    cp -r "$source/content/square" square
    start --level "$work/square/square.gltf"
    cp square/square.gltf kept.gltf
    head -c 1000 kept.gltf > square/square.gltf
    await "error: .*square.gltf"
    cp kept.gltf square/square.gltf
    await "level loaded again"
    stop
    ;;
no_display)
    code=0
    env -u DISPLAY -u WAYLAND_DISPLAY "$sandbox" > "$log" 2>&1 || code=$?
    [ "$code" -eq 4 ] || fail "exit code $code instead of 4"
    [ "$(wc -l < "$log")" -eq 1 ] || fail "not one line"
    grep -q "rushlight capture" "$log" || fail "no hint"
    ;;
*) fail "no such case: $case_name" ;;
esac
