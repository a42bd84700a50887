# Sourced by the stories of sound: what is played, and how it must arrive. capture.cpp records and
# measures; the story starts a server without a card, and says how it is recorded.
. "$(dirname "${BASH_SOURCE[0]}")/story.sh"

capture=$2
export XDG_RUNTIME_DIR=$scratch

# waveform NAME SECONDS AWK-EXPRESSION: samples in g at 10 kHz; t is the time in s.
waveform() {
    awk -v s="$2" 'function c(x) { return cos(6.283185307179586 * x) }
        function w(x) { return sin(6.283185307179586 * x) }
        BEGIN { for (n = 0; n < 10000 * s; ++n) { t = n / 10000; printf "%.12f\n", '"$3"' } }' \
        >"$scratch/set/$1.txt"
}

mkdir "$scratch/set"
waveform tone 2 '0.5 * w(150 * t)'
# Two carriers, the sum of them modulated: six lines.
waveform mixed 2 '0.19 * (w(80 * t) + w(250 * t)) * (1 - c(10 * t))'
tone_lines=(150:0.5)
mixed_lines=(70:0.095 80:0.19 90:0.095 240:0.095 250:0.19 260:0.095)

# As it is: ramps and filters would be heard in what is measured.
play() {
    "$program" play "$scratch/set" --level 1 --no-protection "${device[@]}" "$@" 2>"$scratch/err"
}

is_dropped() { grep -q "it stopped taking sound" "$scratch/err"; }

# arrives NAME DURATION LINES...: what is played is what is recorded. On a busy computer there may be
# gaps, and then another try; but never one that the program does not tell. A server may tell of one
# that its own clock made up for.
# A recorder that loses samples leaves no silence where they were: then the play is heard once more. So it is where
# the server has dropped a program that a busy computer let wait, which the program tells.
arrives() {
    local name=$1 round told gap_ms whole
    shift
    for round in $(seq 30); do
        start_capture
        if ! play --pattern "$name" --json --buffer "$((round < 10 ? 100 * round : 1000))" >"$scratch/report"; then
            is_dropped || fail "it does not play $name"
            stop_capture
            echo "once more: the server has dropped it"
            continue
        fi
        sleep 0.2
        stop_capture
        told=$(sed -n 's/.*"dropouts":\([0-9]*\).*/\1/p' "$scratch/report")
        gap_ms=$("$capture" gap "$scratch/raw" 4 2)
        whole=yes
        "$capture" lines "$scratch/raw" 4 2 "$@" || whole=no
        # PulseAudio leaves no trace of a single period, 5 ms, that came just too late.
        [ "$told" -gt 0 ] || [ "$gap_ms" -le 6 ] || fail "$name has a gap of $gap_ms ms, and it says that it has none"
        # Where a server tells again and again of gaps that do not exist, it is enough that all arrived.
        [ "$whole" = no ] || { [ "$told" -gt 0 ] && [ "$round" -le 5 ]; } || return 0
        echo "once more: it tells $told gaps, the longest silence is of $gap_ms ms"
    done
    fail "$name never arrived as it was"
}

# tells_gaps NAME: halted for longer than what it has rendered ahead, the program says that there was
# a gap, and there is one.
tells_gaps() {
    local playing told gap_ms
    start_capture
    : >"$scratch/err"  # of an earlier play
    play --pattern "$1" --json --buffer 20 >"$scratch/report" &
    playing=$!
    children+=("$playing")
    until_true "it plays" grep -q "playing on" "$scratch/err"
    sleep 1
    kill -STOP "$(pgrep -P "$playing")"
    sleep 0.2
    kill -CONT "$(pgrep -P "$playing")"
    wait "$playing" || fail "it does not play on after a halt"
    sleep 0.2
    stop_capture
    told=$(sed -n 's/.*"dropouts":\([0-9]*\).*/\1/p' "$scratch/report")
    gap_ms=$("$capture" gap "$scratch/raw" 4 2)
    [ "$gap_ms" -ge "${least_gap_ms:-50}" ] || fail "a halt of 200 ms leaves a gap of $gap_ms ms"
    [ "$told" -gt 0 ] || fail "there is a gap of $gap_ms ms, and it says that there is none"
    grep -q "had gaps" "$scratch/err" || fail "no word about the gap"
    echo "told: $told gaps, the longest silence is of $gap_ms ms"
}

# Ctrl+C while a loop plays: silence within 20 ms, and a word about it. A recorder that has to wait
# for the processor stamps too late: one good measurement is proof.
stops_softly() {
    local since code playing round
    for round in 1 2 3 4 5; do
        start_capture
        play --pattern tone --loop &
        playing=$!
        children+=("$playing")
        sleep 1.5
        since=$("$capture" signal 2 "$(pgrep -P "$playing")")
        code=0
        wait "$playing" || code=$?
        [ "$code" -eq 130 ] || fail "exit code $code after Ctrl+C"
        sleep 0.2
        stop_capture
        if "$capture" silent "$scratch/raw" "$scratch/stamps" 4 2 "$since" 20; then return 0; fi
    done
    fail "no stop was silent within 20 ms"
}

# A second program on the same actuator would add up with the first.
plays_alone() {
    local playing code=0
    play --pattern tone --loop &
    playing=$!
    children+=("$playing")
    until_true "the first plays" sounds_on
    is_refused() {
        ! "$program" play "$scratch/set" --level 1 "${device[@]}" --pattern tone 2>"$scratch/second"
        grep -q "another tactspace plays on" "$scratch/second"
    }
    until_true "the second is refused" is_refused
    kill -HUP "$(pgrep -P "$playing")"
    wait "$playing" || code=$?
    [ "$code" -eq 129 ] || fail "exit code $code after SIGHUP"
}

# The server dies while a loop plays: the program says so, and ends.
notices_loss() {
    local code=0 playing
    play --pattern tone --loop &
    playing=$!
    children+=("$playing")
    sleep 1.5
    kill -9 "$server"
    wait "$server" 2>/dev/null || true
    until_true "the loss is noticed" is_gone "$playing"
    wait "$playing" || code=$?
    [ "$code" -eq 1 ] || fail "exit code $code when the server was gone"
    grep -q "is gone: it stopped taking sound" "$scratch/err" || fail "no word about the loss"
    ! grep -v "^tactspace: " "$scratch/err" || fail "the libraries' own words reach the terminal"
    echo "noticed: $(tail -n 1 "$scratch/err")"
}
