#!/bin/sh
# Shared by sandbox/run, tests/run and .ci/run: installs the Debian 12 packages that are missing. Sourced.

rushlight_packages="cmake ninja-build g++ ccache pkg-config
libglfw3-dev libegl-dev libgl-dev libegl1 libgl1-mesa-dri libosmesa6
libglm-dev libtinygltf-dev libdraco-dev libmeshoptimizer-dev libopenimageio-dev openimageio-tools libtbb-dev libhwy-dev libembree-dev
libimgui-dev libstb-dev libcli11-dev nlohmann-json3-dev libexpected-dev libgtest-dev libgmock-dev libbenchmark-dev xvfb xauth"

# What tests alone need: without them they say that they skip.
rushlight_test_packages="clang-format chromium apitrace python3-renderdoc slurm-wlm munge"

# Arguments: further packages.
rushlight_install() {
    missing=""
    for package in $rushlight_packages "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
            missing="$missing $package"
    done
    [ -z "$missing" ] && return 0
    by_hand="apt-get update && apt-get install -y --no-install-recommends$missing"
    as_root=""
    if [ "$(id -u)" != 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "rushlight: error: packages: some are missing and there is no sudo; run as root: $by_hand" >&2
            return 1
        fi
        as_root="sudo"
    fi
    echo "Installing:$missing"
    # shellcheck disable=SC2086  # words on purpose
    $as_root apt-get update && $as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends $missing && return 0
    echo "rushlight: error: packages: installing failed; run as root: $by_hand" >&2
    return 1
}
