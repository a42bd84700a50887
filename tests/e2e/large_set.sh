# Sourced by stories of large sets: patterns so short that a thousand of them take seconds.

# MPI leaks; the unit tests look for leaks of ours.
export ASAN_OPTIONS=detect_leaks=0${ASAN_OPTIONS:+:$ASAN_OPTIONS}

# A set of that many patterns of 30 ms, all different.
make_set() {
    awk -v count="$1" 'BEGIN {
        printf "{\"tactspace\": 1, \"patterns\": ["
        for (k = 0; k < count; ++k) {
            printf "%s{\"name\": \"p%d\", \"duration_s\": 0.03, \"amplitude_g\": %.1f,", \
                k ? "," : "", k, 0.3 + k % 23 / 10
            printf " \"carriers\": [{\"frequency_hz\": %d}],", 30 + k * 7 % 270
            printf " \"modulation\": {\"frequency_hz\": %d}}", k * 3 % 41
        }
        print "]}"
    }' >"$2"
}

# The same of many lengths, 30 ms to 1 s.
make_mixed_set() {
    awk -v count="$1" 'BEGIN {
        printf "{\"tactspace\": 1, \"patterns\": ["
        for (k = 0; k < count; ++k) {
            printf "%s{\"name\": \"p%d\", \"duration_s\": %.2f, \"amplitude_g\": %.1f,", \
                k ? "," : "", k, 0.03 + k * k % 98 / 100, 0.3 + k % 23 / 10
            printf " \"carriers\": [{\"frequency_hz\": %d}],", 30 + k * 7 % 270
            printf " \"modulation\": {\"frequency_hz\": %d}}", k * 3 % 41
        }
        print "]}"
    }' >"$2"
}

fail() {
    echo "FAILED: $*"
    exit 1
}

# The new folder of this story; gone when it ends.
enter_folder() {
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    cd "$folder"
}
