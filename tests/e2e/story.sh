# Sourced by the stories, once: the program, a folder of their own, waiting for what must come, and
# an end that leaves nothing behind.
#
# Everything waits for what it expects, up to a deadline; no story relies on how fast a machine is.
if declare -F until_true >/dev/null; then return 0; fi
set -euo pipefail # so "| grep -q" is no test: it ends what it reads from, which then failed

program=$1
looks=3000  # most of them 0.1 s apart, at least

# need PACKAGES TOOL...: without the tools there is no story.
need() {
    local packages=$1 tool
    shift
    for tool in "$@"; do
        command -v "$tool" >/dev/null && continue
        echo "$tool is missing: sudo apt-get install $packages"
        [ -n "${CI:-}" ] && exit 1
        exit 77
    done
}

scratch=$(mktemp -d)
export HOME=$scratch
# Drivers of displays and libraries of sound leak; the unit tests look for leaks of ours.
export ASAN_OPTIONS=detect_leaks=0${ASAN_OPTIONS:+:$ASAN_OPTIONS}
children=()  # started here, and to be ended here

is_gone() { ! kill -0 "$1" 2>/dev/null; }
# In a group of processes that nobody waits for no program halts: it continues by itself.
is_halted() { [[ $(ps -o stat= -p "$1") == T* ]]; }
are_gone() {
    local child
    for child in "${children[@]}"; do is_gone "$child" || return 1; done
}

# What asks servers to end gives them time to: they tidy up behind themselves.
end_children() {
    [ "${#children[@]}" -gt 0 ] || return 0
    kill "${children[@]}" 2>/dev/null || true
    local end=$((SECONDS + 5))
    until are_gone || [ "$SECONDS" -ge "$end" ]; do sleep 0.02; done
    kill -9 "${children[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
}

end_story() {
    local code=$?
    if [ "$code" -ne 0 ] && [ "$code" -ne 77 ]; then
        cat "$scratch/err" 2>/dev/null || true
        tail -n 5 "$scratch/log" 2>/dev/null || true
    fi
    end_children
    rm -rf "$scratch"
}
trap end_story EXIT

fail() {
    echo "failed: $*"
    tell_more
    if [ -s "${TACTSPACE_WIDGET_RECTS:-}" ]; then grep -v '^point:' "$TACTSPACE_WIDGET_RECTS"; fi
    exit 1
}

tell_more() { :; }  # besides what failed
progress() { :; }  # what changes while work is under way

# until_true WHAT COMMAND...: the command must succeed within a number of looks, which starts again with each
# sign of progress. They are counted, not timed: on a busy machine they take longer, and one that was
# halted continues where it was. What takes long is looked at less often: looking takes the processor, too.
until_true() {
    local what=$1 seen="" now tries=0
    shift
    until "$@"; do
        if ((++tries < 50)); then
            sleep 0.02
            continue
        fi
        now=$(progress)
        if [ "$now" != "$seen" ]; then
            seen=$now
            tries=50
        fi
        ((tries < looks)) || fail "looked $looks times until $what"
        sleep 0.1
    done
}
