# Sourced by the tables of endings on outputs, beside a server of that many "channels", which start_capture
# records and all_sound and is_up look at: however a play ends, its channel is silent within 100 ms, and
# stays so. Signals are sent to one program each, on channels of their own, at one time.

most_ms=100
rounds=5 # a recorder that has to wait stamps too late: one good measurement is proof

# Signals that a shell keeps from what it starts beside itself are as they are usually.
start_loop() { # CHANNEL
    env --default-signal=INT,QUIT "$program" play "$scratch/set" --level 1 --no-protection "${device[@]}" \
        --channel "$1" --pattern tone --loop 2>"$scratch/err$1" &
    players[$1]=$!
    children+=("$!")
}
plays() { grep -q "playing on" "$scratch/err$1" 2>/dev/null; }

# Its exit code, into "code": a shell knows the end of its own children alone.
await_end() { # CHANNEL
    code=0
    until_true "channel $1's program has ended" is_gone "${players[$1]}"
    wait "${players[$1]}" 2>/dev/null || code=$?
}
is_halted_or_gone() { is_halted "$1" || is_gone "$1"; }

# The end of the last sound, with silence recorded after it. What JACK's recorder is given ends early where
# another client crashes.
is_in_time() { # CHANNEL NAME
    local heard
    heard=$("$capture" rest "$scratch/raw" "$scratch/stamps" "$channels" "$1" "${since[$1]}") ||
        { echo "$2: $heard"; return 1; }
    echo "$2: last heard after ${heard% *} ms"
    awk -v heard="$heard" -v most="$most_ms" \
        'BEGIN { split(heard, h, " "); exit !(h[1] >= -500 && h[1] <= most && h[2] >= 20) }'
}

# A server may lose a client for good that comes too late for many a period, and then nothing is heard of it:
# such a round counts for nothing, and another one begins, with another server.
sounds_or_starts_anew() { # CHANNELS
    local tries
    for tries in {1..200}; do
        ! all_sound "$1" || return 0
        sleep 0.1
    done
    echo "not all $1 are heard: once more, on another server"
    kill -9 "${players[@]}" "$recorder" "$server" 2>/dev/null || true
    wait "${players[@]}" "$recorder" "$server" 2>/dev/null || true
    start_anew
    return 1
}

# All of them at once; prints what was missed.
signals_once() { # NAME...
    local channel=0 name all=yes
    players=()
    since=()
    start_capture
    for name in "$@"; do start_loop $((++channel)); done
    for channel in $(seq $#); do until_true "$channel plays" plays "$channel"; done
    sounds_or_starts_anew $# || return 1
    channel=0
    for name in "$@"; do
        channel=$((channel + 1))
        since[channel]=$("$capture" signal "$(kill -l "$name")" "${players[channel]}")
    done
    sleep 0.5
    go_on "$@"
    sleep 0.3
    stop_capture
    channel=0
    for name in "$@"; do
        ends_as_it_should $((++channel)) "$name"
        is_in_time "$channel" "SIG$name" || all=no
    done
    [ "$all" = yes ]
}

# What was halted stays at rest when it continues, and says so.
go_on() {
    local channel=0 name
    for name in "$@"; do
        channel=$((channel + 1))
        [ "$name" = TSTP ] || continue
        until_true "it is halted" is_halted_or_gone "${players[channel]}"
        kill -CONT "${players[channel]}" 2>/dev/null || true
    done
}
ends_as_it_should() { # CHANNEL NAME
    local wanted=$((128 + $(kill -l "$2")))
    [ "$2" != TSTP ] || wanted=1
    [ "$2" != STOP ] || kill -9 "${players[$1]}"
    await_end "$1"
    [ "$2" != STOP ] || return 0
    [ "$code" -eq "$wanted" ] || fail "exit code $code after SIG$2, not $wanted"
    [ "$2" != TSTP ] || grep -q "was put to rest when the program was halted" "$scratch/err$1" ||
        fail "no word about the halt: $(cat "$scratch/err$1")"
}

rests_after() { # NAME...
    local round
    for round in $(seq "$rounds"); do ! signals_once "$@" || return 0; done
    fail "some ending was never silent within $most_ms ms"
}

# A pattern to its end, and a loop to the end of its time: heard whole, and then silence.
ends_by_itself() {
    local channel round
    for round in $(seq "$rounds"); do
        start_capture
        play --channel 1 --pattern tone || fail "exit code $? at the end of a pattern"
        since[1]=$("$capture" now)
        play --channel 2 --pattern tone --loop --longest 1 || fail "exit code $? at the end of a loop's time"
        since[2]=$("$capture" now)
        sleep 0.3
        stop_capture
        is_in_time 1 "a pattern's end" && is_in_time 2 "a loop's end" && return 0
    done
    fail "what ends is never silent within $most_ms ms"
}

# The server hangs for a while, and the person presses Ctrl+C meanwhile: counted from when it is back.
bears_a_stall() {
    local round
    players=()
    for round in $(seq "$rounds"); do
        start_capture
        start_loop 1
        sounds_or_starts_anew 1 || continue
        kill -STOP "$server"
        sleep 0.3
        kill -INT "${players[1]}"
        since[1]=$("$capture" now)
        kill -CONT "$server"
        await_end 1
        [ "$code" -eq 130 ] || fail "exit code $code after Ctrl+C beside a server that hangs"
        sleep 0.3
        stop_capture
        ! is_in_time 1 "a stall, then SIGINT" || return 0
    done
    fail "after a stall it is never silent within $most_ms ms"
}

# The server is killed: the program ends, and what comes in its place is given nothing.
dies_with_server() {
    local round
    players=()
    for round in $(seq "$rounds"); do
        start_capture
        start_loop 1
        ! sounds_or_starts_anew 1 || break
        [ "$round" -lt "$rounds" ] || fail "the loop is never heard"
    done
    kill -9 "$server" "$recorder"
    wait "$server" "$recorder" 2>/dev/null || true
    start_server
    until_true "the next server answers" is_up
    await_end 1
    [ "$code" -eq 1 ] || fail "exit code $code when the server is gone"
    start_capture
    sleep 0.3
    stop_capture
    [ "$("$capture" peaks "$scratch/raw" "$channels" 1)" = "0 0" ] || fail "a server that was started again is given a sound"
    echo "server killed: nothing on the next one"
}
