// A waveform on a page: as a small picture, and to be heard.
//
// Source    RIFF WAVE, 16-bit PCM; data: URIs, RFC 2397; base64, RFC 4648
#pragma once

#include <string>
#include <string_view>

#include "model/signal/waveform.h"

namespace tact {

// Light where it is modulated faster than can be drawn, with an outline.
struct WaveThumbnail {
    std::string html;
    bool is_light = false;  // somewhere
};

// As a share of full scale, +-reach_g, over `end_s`: as the program's lists show it.
WaveThumbnail thumbnail_html(const Waveform& waveform, double reach_g, double end_s);

// As far as carriers go (1 kHz), with room for the filter; browsers play 3 kHz and more.
inline constexpr double kPlayerRateHz = 4000.0;

// All players of one page share a full scale, so that louder is stronger. One that is not ready
// waits until it is pressed: of ready ones a page may have about seventy.
std::string player_html(const Waveform& waveform, double full_scale_g, const std::string& name,
                        bool is_ready = true);

// What a player takes of the page.
std::size_t player_bytes(const Waveform& waveform);

std::string base64(std::string_view bytes);

// At the waveform's own rate; what is beyond full scale is cut off.
std::string wave_bytes(const Waveform& waveform, double full_scale_g);

}  // namespace tact
