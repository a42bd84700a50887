#include "app/phones/phones.h"

#include <qrencode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "assets/assets.h"
#include "devices/device/drive.h"
#include "devices/phone/on_off_times.h"
#include "model/io/effects_out/on_off.h"
#include "model/text/numbers.h"

namespace tact {

std::vector<PageFile> phone_page() {
    const auto file = [](const char* name, const char* type) {
        const std::string path = std::string("phone/") + name;
        return PageFile{name, std::string(type) + "; charset=utf-8", std::string(asset(path))};
    };
    return {file("index.html", "text/html"), file("phone.js", "text/javascript"),
            file("phone.css", "text/css"), file("texts.json", "application/json")};
}

namespace {

constexpr double kSmallLossS = 0.02;  // less than that is within the pulses' own rounding

std::string loss_of(const OnOff& played) {
    if (!is_ever_on(played.ms)) return "Too weak for a phone: nothing is felt.";
    if (played.floor_lost_s < kSmallLossS) return {};
    return significant_digits(played.floor_lost_s, 2) + " s of it are too weak for a phone.";
}

// Waveforms of a large set are too many to be kept for what comes next: they are rendered again.
std::optional<double> full_scale_of(const PatternSet& set, const std::stop_token& stop) {
    double loudest_g = 0.0;
    for (const Vibration& vibration : set.vibrations) {
        if (stop.stop_requested()) return std::nullopt;
        const double peak = peak_g(waveform_of(vibration));
        if (std::isfinite(peak)) loudest_g = std::max(loudest_g, peak);
    }
    return loudest_g > 0.0 ? loudest_g : 1.0;
}

}  // namespace

std::optional<PhonePatterns> phone_patterns(const PatternSet& set, std::stop_token stop) {
    const std::optional<double> full_scale_g = full_scale_of(set, stop);
    if (!full_scale_g) return std::nullopt;
    PhonePatterns made{{}, *full_scale_g};
    for (const Vibration& vibration : set.vibrations) {
        if (stop.stop_requested()) return std::nullopt;
        const Drive drive = drive_of(waveform_of(vibration), *full_scale_g);
        OnOff played = on_off_of_drive(drive.samples, drive.rate_hz, 1.0);
        std::string loss = loss_of(played);
        made.patterns.push_back({vibration.name, std::move(played.ms), std::move(loss)});
    }
    return made;
}

namespace {

// The quiet zone is light, and so is what lies beyond it.
bool is_light(const QrCode& code, std::size_t row, std::size_t column) {
    const bool inside = row >= kQuietModules && row < kQuietModules + code.side &&
                        column >= kQuietModules && column < kQuietModules + code.side;
    if (!inside) return true;
    return !code.dark[(row - kQuietModules) * code.side + column - kQuietModules];
}

}  // namespace

QrCode qr_code(const std::string& text) {
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
        QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M), &QRcode_free);
    if (!made) return {};
    QrCode code;
    code.side = static_cast<std::size_t>(made->width);
    code.dark.reserve(code.side * code.side);
    for (std::size_t k = 0; k < code.side * code.side; ++k) {
        code.dark.push_back((made->data[k] & 1U) != 0);
    }
    return code;
}

std::string lines_of(const QrCode& code, bool coloured) {
    constexpr std::array kBlocks{" ", "\u2584", "\u2580", "\u2588"};  // none, lower, upper, both
    if (code.side == 0) return {};
    const std::size_t side = code.side + 2 * kQuietModules;
    std::string text;
    for (std::size_t row = 0; row < side; row += 2) {
        if (coloured) text += "\033[97;40m";
        for (std::size_t column = 0; column < side; ++column) {
            const bool upper = is_light(code, row, column);
            // An odd number of rows: below the last one nothing is drawn.
            const bool lower = row + 1 < side && is_light(code, row + 1, column);
            text += kBlocks[(upper ? 2U : 0U) + (lower ? 1U : 0U)];
        }
        if (coloured) text += "\033[0m";
        text += "\n";
    }
    return text;
}

}  // namespace tact
