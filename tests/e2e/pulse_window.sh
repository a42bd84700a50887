# Sourced by the stories that play from the window through PulseAudio, after window.sh and pulse.sh:
# chooses the second of four channels.
output=audio/ALSA/pulse

is_on() { [ "$(value "$1")" = on ]; }
is_off() { [ "$(value "$1")" = off ]; }
is_chosen() { [ "$(value "choose:$1")" = chosen ]; }
# A menu may not be there yet, or close again where the list of devices changes: then it tries again.
shows_menu() {
    shows device:dialog || { click device && soon shows device:dialog; }
}
# In a combo of the dialog, whose list may still be on its way to its place: then it tries again.
chooses() { # FIELD VALUE
    shows "choose:$1 $2" || click "combo:$1"
    soon shows "choose:$1 $2" || return 1
    click "choose:$1 $2"
    soon says "combo:$1" "$2"
}
choose() { until_true "$1 is $2" chooses "$1" "$2"; }
is_quiet() { ! sounds; }
sounds() { awk -v meter="$(value meter)" 'BEGIN { exit !(meter > 0) }'; }

play_on() { # the meter falls slowly
    until_true "it is quiet" is_quiet
    key space
    until_true "it sounds" sounds
}

choose_output() {
    until_true "there is the menu of devices" shows_menu
    click device:dialog
    until_true "the output is listed" shows "choose:$output"
    click "choose:$output"
    until_true "it is chosen" is_chosen "$output"
    choose channel "2, front right"
    click button:close
    until_true "the bar names it" says device ", 2"
}

start_server
until_true "the server is listed" is_listed
