# Sourced by the stories that play through JACK: a server without a card, and a client that records.
. "$(dirname "${BASH_SOURCE[0]}")/sound.sh"
need jackd2 jackd
unset DISPLAY WAYLAND_DISPLAY

# JACK has room for eight servers' names, and keeps that of a killed one until a server of the same
# name comes. Hence one name for all, and one story at a time.
export JACK_DEFAULT_SERVER=tactspace_story
exec 9>"${TMPDIR:-/tmp}/tactspace_jack.$(id -u)"
flock --timeout 60 9 || fail "another story of JACK does not end"

start_server() {
    jackd --no-realtime -n "$JACK_DEFAULT_SERVER" -d dummy -r 48000 -p "${period:-256}" -P 4 -C 4 \
        >"$scratch/log" 2>&1 9>&- &
    server=$!
    children+=("$server")
    until_true "the server is listed" is_listed
}
is_listed() { "$program" devices 2>"$scratch/noise" | grep "^audio/JACK/system " >/dev/null; }

is_ready() { grep -q ready "$scratch/ready" 2>/dev/null; }
start_capture() {
    rm -f "$scratch/ready"
    "$capture" jack "${channels:-4}" "$scratch/raw" "$scratch/stamps" >"$scratch/ready" 2>/dev/null &
    recorder=$!
    children+=("$recorder")
    until_true "the recorder runs" is_ready
}
stop_capture() {
    kill "$recorder"
    wait "$recorder" 2>/dev/null || true
}
