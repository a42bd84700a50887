# Sourced by tests/install and tests/machines: a Debian in a folder of its own, with nothing in it but what it
# needs to be one. As root, with a Debian mirror in reach.
[ "$(id -u)" -eq 0 ] || { echo "${0#"$PWD/"}: expected root, as debootstrap and chroot need it"; exit 1; }
need_packages debootstrap

# Large: not where a machine keeps what is in memory.
scratch=$(mktemp -d -p /var/tmp)
root=$scratch/root
inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 ${http_proxy:+http_proxy="$http_proxy"} \
    ${https_proxy:+https_proxy="$https_proxy"} "$@"; }
finish() {
    local code=$?
    local mounted
    for mounted in dev/pts dev/shm proc; do umount "$root/$mounted" 2>/dev/null || true; done
    rm -rf --one-file-system "$scratch"
    exit "$code"
}
trap finish EXIT
fail() {
    echo "failed: $*"
    exit 1
}

# bare_system bookworm|trixie PACKAGES,WITH,COMMAS
bare_system() {
    debootstrap --variant=minbase --include="$2" "$1" "$root" >"$scratch/log" 2>&1 ||
        { tail -5 "$scratch/log"; fail "no Debian was made"; }
    mount -t proc proc "$root/proc"
    mkdir -p "$root/dev/shm" "$root/dev/pts"
    mount -t tmpfs tmpfs "$root/dev/shm"
    # Terminals of its own, which tests write to and umockdev makes devices of.
    mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$root/dev/pts"
    cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
    inside apt-get update -q >"$scratch/log" 2>&1 || { tail -5 "$scratch/log"; fail "no package lists"; }
}
