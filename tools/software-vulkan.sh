#!/usr/bin/env bash
# Prints the line that makes wgpu see software Vulkan devices, for machines without a GPU and for CI:
#
#     eval "$(tools/software-vulkan.sh)"
#
# Two devices, because two drivers err in different places: lavapipe (named `llvmpipe`), which Debian's and Ubuntu's
# package mesa-vulkan-drivers installs, and SwiftShader, which this script takes out of Debian's package
# chromium-common without installing that (32 MB, once, into target/swiftshader). Nothing on the system is changed.
# What is missing is said on stderr, with the command that helps; without any device the script fails.
set -euo pipefail
shopt -s nullglob

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
swiftshader=$root/target/swiftshader

say() { printf 'software-vulkan: %s\n' "$*" >&2; }

# Leaves a complete folder or none, however it ends.
unpack_swiftshader() {
    local work
    mkdir -p "$root/target"
    work=$(mktemp -d "$root/target/swiftshader.XXXXXX")
    if ! { (cd "$work" && apt-get -o APT::Sandbox::User=root download chromium-common) &&
        dpkg -x "$work"/chromium-common_*.deb "$work" &&
        mkdir "$work/driver" &&
        mv "$work"/usr/lib/*/{libvk_swiftshader.so,vk_swiftshader_icd.json} "$work/driver" &&
        mv -T "$work/driver" "$swiftshader"; } >&2
    then
        say "no SwiftShader; it comes from Debian's package chromium-common: as root, apt-get update, then try again"
    fi
    rm -rf "$work"
}

drivers=()
for icd in /usr/share/vulkan/icd.d/lvp_icd*.json /etc/vulkan/icd.d/lvp_icd*.json; do
    drivers+=("$icd")
    break
done
if ((${#drivers[@]} == 0)); then
    say "no lavapipe; as root: apt-get install --no-install-recommends mesa-vulkan-drivers"
fi

if [[ ! -e $swiftshader/vk_swiftshader_icd.json ]]; then
    unpack_swiftshader
fi
if [[ -e $swiftshader/vk_swiftshader_icd.json ]]; then
    drivers+=("$swiftshader/vk_swiftshader_icd.json")
fi

if ((${#drivers[@]} == 0)); then
    exit 1
fi
# The layer that NODEVICE_SELECT switches off looks for a display and complains when there is none.
printf 'export VK_DRIVER_FILES=%q NODEVICE_SELECT=1\n' "$(IFS=: && echo "${drivers[*]}")"
