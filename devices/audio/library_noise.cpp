#include "devices/audio/library_noise.h"

#include <alsa/asoundlib.h>
#include <jack/jack.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

namespace tact {

namespace {

void ignore_alsa(const char*, int, const char*, int, const char*, ...) {}
void ignore_jack(const char*) {}

#ifdef __GLIBC__
// One call of fprintf is one piece: the stream is not buffered.
ssize_t pass_on(void*, const char* text, std::size_t size) {
    if (std::string_view(text, size).starts_with("Expression '")) return static_cast<ssize_t>(size);
    return ::write(STDERR_FILENO, text, size);
}
#endif

}  // namespace

void filter_standard_error() {
#ifdef __GLIBC__
    cookie_io_functions_t functions{};
    functions.write = pass_on;
    FILE* filtered = fopencookie(nullptr, "w", functions);
    if (filtered == nullptr) return;
    std::setvbuf(filtered, nullptr, _IONBF, 0);
    stderr = filtered;  // a variable, in glibc
#endif
}

void silence_libraries() {
    snd_lib_error_set_handler(ignore_alsa);
    jack_set_error_function(ignore_jack);
    jack_set_info_function(ignore_jack);
}

}  // namespace tact
