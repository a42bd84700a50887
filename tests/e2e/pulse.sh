# Sourced by the stories that play through PulseAudio: a server without a card, with a sink of four
# channels, and a recorder of what the sink is given.
. "$(dirname "${BASH_SOURCE[0]}")/sound.sh"
need "pulseaudio pulseaudio-utils libasound2-plugins" pulseaudio parec pactl

export PULSE_SERVER=unix:$scratch/s
map=front-left,front-right,rear-left,rear-right

sink="module-null-sink sink_name=haptic rate=48000 channels=4 format=float32le channel_map=$map"

# Without shared memory: the server loses count of its blocks now and then, and aborts ("non-registered
# memfd ID", its issue 824).
start_server() {
    pulseaudio -n --daemonize=no --exit-idle-time=-1 --use-pid-file=no --disable-shm=yes \
        --log-target="file:$scratch/log" -L "$sink" \
        -L "module-native-protocol-unix socket=$scratch/s auth-anonymous=1" &
    server=$!
    children+=("$server")
}

# Without --latency-msec the last two seconds are lost at the end.
start_capture() {
    : >"$scratch/stamps"
    parec -d "${source:-haptic.monitor}" --format=float32le --rate=48000 --channels=4 --channel-map=$map \
        --no-remix --raw --latency-msec="${capture_ms:-5}" > >("$capture" read 4 "$scratch/raw" "$scratch/stamps") &
    recorder=$!
    children+=("$recorder")
    until_true "something is recorded" test -s "$scratch/stamps"
}
stop_capture() {
    kill "$recorder"
    wait "$recorder" 2>/dev/null || true
    sleep 0.1
}

sounds_on() { pactl list short sink-inputs | grep . >/dev/null; }
is_listed() { "$program" devices 2>"$scratch/noise" | grep "^audio/ALSA/pulse " >/dev/null; }
