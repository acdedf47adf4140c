#!/bin/sh
# debuggers_test.sh apitrace|renderdoc TOOL SOURCE_DIR WORK_DIR: what a frame looks like to other people's debuggers: every
# pass a group, every object with a label, and a recording that draws the same picture. 77 where the debugger is missing.
set -eu
case_name=$1 tool=$2 source=$3 work=$4
rm -rf "$work" && mkdir -p "$work" && cd "$work"
display=$source/tests/support/with_display.sh
scene=$source/content/testcard/testcard.gltf
# The recording and its replay shall have the same driver, whatever the machine has.
export LIBGL_ALWAYS_SOFTWARE=1

fail() { echo "FAILED: $*"; exit 1; }
skip() { echo "SKIPPED: $*"; exit 77; }
need() { command -v "$1" >/dev/null || skip "$1 is not installed (Debian's package $2)"; }

# The passes that the tool says it drew, in order.
passes_of() { sed -n '/"passes"/,$ s/^ *"name": "\(.*\)",$/\1/p' "$1"; }

case $case_name in
apitrace)
    need apitrace apitrace
    need eglretrace apitrace
    need xvfb-run xvfb
    apitrace trace --api egl -o frame.trace "$tool" capture "$scene" -o frame.png --size 160x90 \
        --context egl --stats stats.json > log.txt 2>&1 || { cat log.txt; fail "tracing"; }
    apitrace dump --color=never frame.trace > calls.txt

    passes_of stats.json > passes.txt
    [ -s passes.txt ] || fail "the tool names no passes"
    sed -n 's/.*glPushDebugGroup(.*message = "\(.*\)")$/\1/p' calls.txt > groups.txt
    diff passes.txt groups.txt || fail "the debug groups are not the passes"
    [ "$(grep -c 'glPushDebugGroup(' calls.txt)" -eq "$(grep -c 'glPopDebugGroup(' calls.txt)" ] ||
        fail "groups are not closed"

    awk -f "$source/tests/gl/unlabelled.awk" calls.txt || fail "objects have no label"

    last=$(sed -n 's/^\([0-9]*\) gl\(Multi\)\{0,1\}Draw.*/\1/p' calls.txt | tail -n 1)
    "$display" eglretrace -S "$last" -s replayed. frame.trace > retrace.txt 2>&1 ||
        { tail -n 20 retrace.txt; fail "the replay"; }
    ! grep -E "error|warning" retrace.txt || fail "the replay complains"
    "$tool" compare frame.png replayed.*.png --max-error 0 || fail "the replay shows another picture"
    ;;
renderdoc)
    python=/usr/bin/python3  # Debian's, which Debian's modules are for
    need xvfb-run xvfb
    "$python" -c "import renderdoc" 2>/dev/null ||
        skip "RenderDoc's Python module is not installed (Debian's package python3-renderdoc)"
    # RenderDoc's own crashes (a code over 128) are not ours: seen once in some twenty runs.
    tries=0 code=255
    while [ "$code" -gt 128 ] && [ "$tries" -lt 3 ]; do
        tries=$((tries + 1)) code=0
        "$display" "$python" "$source/tests/gl/renderdoc_frame.py" "$tool" "$scene" "$work" || code=$?
    done
    [ "$code" -le 128 ] || skip "RenderDoc crashed $tries times (code $code)"
    [ "$code" -eq 0 ] || fail "see above"
    "$display" "$tool" view "$scene" --size 160x90 --frames 3 --screenshot frame.png > log.txt 2>&1 ||
        { cat log.txt; fail "the screenshot"; }
    "$tool" compare frame.png replayed.png --max-error 0 || fail "RenderDoc shows another picture"
    ;;
*) fail "no such case: $case_name" ;;
esac
