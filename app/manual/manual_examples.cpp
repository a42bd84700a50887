#include "app/manual/manual_examples.h"

#include <algorithm>

#include "app/report/html.h"
#include "assets/assets.h"
#include "model/io/effects_out/write_effect.h"

namespace tact {

namespace {

std::string text_html(std::string_view text) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    return "<pre>" + html_escaped(text) + "</pre>";
}

std::string folded_html(const std::string& heading, std::string_view text) {
    return "<details><summary>" + heading + "</summary>\n" + text_html(text) + "</details>\n";
}

}  // namespace

Expected<std::string> example_html(std::string_view file) {
    const std::string path = "manual/examples/" + std::string(file);
    const auto all = assets();
    if (std::ranges::find(all, path, &Asset::path) == all.end()) {
        return Error{"expected the name of a file in assets/manual/examples, got \"" +
                     std::string(file) + "\""};
    }
    return "<p class=\"file\"><code>" + html_escaped(file) + "</code></p>\n" +
           text_html(asset(path)) + "\n";
}

Pattern manual_pattern() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.duration_s = 0.3;
    pattern.carriers[0].frequency_hz = 150.0;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.2, 1.0}, {0.3, 0.0}};
    pattern.transients = {{0.05, 0.7, 150.0, 0.02}};
    return pattern;
}

Expected<std::string> effect_html(std::string_view key) {
    const auto format = target_format_of(key);
    if (!format || is_sampled(*format)) {
        return Error{"expected the key of a format that effects are exported to, got \"" +
                     std::string(key) + "\""};
    }
    const TargetTraits& target = traits(*format);
    const WrittenEffect written =
        write_effect(*format, manual_pattern(), {"swell", bundled_actuator(target.map)});
    const std::string heading =
        html_escaped(target.title) + ", <code>swell" + html_escaped(target.ending) + "</code>";
    std::string html = folded_html(heading, written.text);
    if (*target.beside != '\0') {
        html += folded_html("and beside it <code>swell" + html_escaped(target.beside) + "</code>",
                            written.beside);
    }
    return html;
}

}  // namespace tact
