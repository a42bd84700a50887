# Sourced by the stories: starts the program in a real window on a display of its own, and finds,
# moves and reads what is in it. The program writes after each frame where its widgets are and what
# they show (TACTSPACE_WIDGET_RECTS): lines of name, left, top, right, bottom and value.
. "$(dirname "${BASH_SOURCE[0]}")/story.sh"
need "xvfb xdotool" Xvfb xdotool

export XDG_STATE_HOME=$scratch/state TACTSPACE_WIDGET_RECTS=$scratch/rects
unset WAYLAND_DISPLAY
pid=""
display_pid=""
: >"$scratch/display"

# Two servers that look for a free number at one time can end up without one: then it tries again. A server that
# resets once its last client has left refuses those who come meanwhile.
display_answers() {
    if [ -z "$display_pid" ] || is_gone "$display_pid"; then
        Xvfb -displayfd 3 -noreset -screen 0 1600x1000x24 -nolisten tcp 3>"$scratch/display" 2>/dev/null &
        display_pid=$!
        children+=("$display_pid")
    fi
    DISPLAY=:$(tail -n 1 "$scratch/display")
    export DISPLAY
    xdotool getdisplaygeometry >/dev/null 2>&1
}

is_drawn() { [ -s "$TACTSPACE_WIDGET_RECTS" ] && window=$(xdotool search --onlyvisible --pid "$pid"); }
is_exact() { says "title:Perceptual space" "exact, "; }  # the preview says "exact 40 %"

# Starts the program with the arguments and waits for its first exact map.
start() {
    rm -f "$TACTSPACE_WIDGET_RECTS"
    "$program" "$@" >"$scratch/out" 2>"$scratch/err" &
    pid=$!
    children+=("$pid")
    until_true "the window is there" is_drawn
    until_true "the map is exact" is_exact
}

# Ends the program as a person does; it must end well.
quit() {
    local code=0
    key ctrl+q
    until_true "the program has ended" is_gone_or_told
    wait "$pid" || code=$?
    pid=""
    [ "$code" -eq 0 ] || fail "exit code $code after Ctrl+Q"
}

# The first time it tells that what is unsaved is kept.
is_gone_or_told() {
    is_gone "$pid" && return
    ! shows "answer:Quit" || key Return
    return 1
}

crash() {
    kill -9 "$pid"
    wait "$pid" 2>/dev/null || true
    pid=""
}

# What the program shows.

value() { awk -F'\t' -v name="$1" '$1 == name { print $6; exit }' "$TACTSPACE_WIDGET_RECTS"; }
middle() {
    awk -F'\t' -v name="$1" '$1 == name { print int(($2 + $4) / 2), int(($3 + $5) / 2); exit }' \
        "$TACTSPACE_WIDGET_RECTS"
}
shows() { grep -q "^$1	" "$TACTSPACE_WIDGET_RECTS"; }
lacks() { ! shows "$1"; }
is_value() { [ "$(value "$1")" = "$2" ]; }
says() { [[ $(value "$1") == *"$2"* ]]; }  # its value has these words
is_within() { # NAME NUMBER TOLERANCE
    awk -v a="$(value "$1")" -v b="$2" -v most="$3" \
        'BEGIN { exit !(a != "" && a - b <= most && b - a <= most) }'
}
is_number() { is_within "$1" "$2" 0; }
is_unsaved() { says document "•"; }
is_saved() { ! is_unsaved; }
points() { grep '^point:' "$TACTSPACE_WIDGET_RECTS" | cut -f 1-3; }

# How far all that works has come.
progress() {
    grep '^title:Perceptual space\|^progress:\|^export progress' "$TACTSPACE_WIDGET_RECTS" 2>/dev/null || true
}

# Exact, and at rest.
has_settled() { is_exact && ! shows "points move"; }

# What a person does.

# By the program's own word: the pointer is where the thing is drawn. A list that opens moves.
point_at() {
    until_true "there is $1" shows "$1"
    until_true "the pointer is on $1" is_reached "$1"
}
is_reached() {
    local place
    place=$(middle "$1")
    [ -n "$place" ] || return 1
    # shellcheck disable=SC2086
    xdotool mousemove --window "$window" $place
    soon is_at pointer "$place" && is_at "$1" "$place"
}
is_at() { [ "$(middle "$1")" = "$2" ]; }
# What appears with an answer may move what stands below it.
rests() { # NAME: it stands where it stood a moment before
    local place
    place=$(grep -m 1 "^$1	" "$TACTSPACE_WIDGET_RECTS") || return
    sleep 0.3
    [ "$place" = "$(grep -m 1 "^$1	" "$TACTSPACE_WIDGET_RECTS")" ]
}
click() { point_at "$1" && xdotool click 1; }
key() { xdotool key "$@"; }
type_text() { xdotool type --delay 20 -- "$1"; }

# Types over the number of a field; KEY takes it, Return if it is not said.
enter() { # FIELD TEXT [KEY]
    click "entry:$1"
    until_true "$1 is being typed" is_typed "$1"
    type_text "$2"
    key "${3:-Return}"
}
is_typed() { says typed "$1"; }

# Types over the text of a field that takes any, until it holds it: typed before the field has the
# keys it is lost.
fill() { # FIELD TEXT
    until_true "$1 holds $2" typed_over "$1" "$2"
}
typed_over() {
    click "$1"
    key ctrl+a
    type_text "$2"
    soon is_value "$1" "$2"
}
soon() { # COMMAND...: it succeeds within 2 s
    local tries
    for tries in {1..40}; do
        "$@" && return
        sleep 0.05
    done
    return 1
}

# A key may come before the window has the keys, and is pressed once more meanwhile.
hears_escape() {
    local listener code=0
    : >"$scratch/listener"
    "$(dirname "$program")/escape_listener" >"$scratch/listener" 2>"$scratch/err" &
    listener=$!
    children+=("$listener")
    until_true "the window draws no more" grep -q drawn "$scratch/listener"
    is_heard() { key Escape && soon is_gone "$listener"; }
    until_true "Esc is heard" is_heard
    wait "$listener" || code=$?
    [ "$code" -eq 0 ] || fail "exit code $code of what listens for Esc"
}

# By the palette.
command_named() { # NAME
    key ctrl+p
    until_true "the palette is open" grep -q "^palette:" "$TACTSPACE_WIDGET_RECTS"
    until_true "it offers $1 first" offers_first "$1"
    key Return
}
offers_first() {
    key ctrl+a
    type_text "$1"
    soon is_first "$1"
}
is_first() { [[ $(grep -m 1 '^palette:' "$TACTSPACE_WIDGET_RECTS") == "palette:$1	"* ]]; }

# Answers the file dialog, which is there or comes.
choose_file() { # PATH
    fill "file name" "$1"
    key Return
    until_true "the file dialog is answered" lacks "file name"
}

# Saves the set as FILE, which ends in .tactspace.json.
save_as() {
    key ctrl+shift+s
    choose_file "${1%.tactspace.json}"
    until_true "$1 is there" test -s "$1"
}

# Where the pointer is; whether COMMAND succeeds then. Two clicks of a busy machine may come too far apart.
double_clicks() { # COMMAND...
    xdotool click --repeat 2 --delay 60 1
    soon "$@"
}

press() { xdotool mousedown 1; }
release() { xdotool mouseup 1; }

# The pointer to a share of the modulation slider's width, the button unchanged.
slide_to() {
    local place
    place=$(awk -F'\t' -v share="$1" '$1 == "slider:modulation_hz" {
        print int($2 + share * ($4 - $2)), int(($3 + $5) / 2); exit }' "$TACTSPACE_WIDGET_RECTS")
    # shellcheck disable=SC2086
    xdotool mousemove --window "$window" $place
}
# From 0 to 100 Hz, over the width less half that of the grab at both ends.
follows() { is_within slider:modulation_hz "$(awk -v share="$1" 'BEGIN { print 100 * share }')" 8; }

# select_pattern NAME HZ: until the editor has its modulation.
select_pattern() {
    click "row:$1"
    until_true "$1 is in the editor" is_number slider:modulation_hz "$2"
}

until_true "there is a display" display_answers
