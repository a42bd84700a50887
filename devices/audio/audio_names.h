// Names of sound cards and channels, as PortAudio has them and as a person knows them.
//
// Left out  translations of what drivers call themselves.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

// "UMC204HD: USB Audio (hw:2,0)" without the place in brackets, which changes from day to day.
std::string card_name(std::string_view name);

// What a person calls it: "PulseAudio" for ALSA's "pulse", "JACK system".
std::string spoken_name(std::string_view interface, std::string_view name);

// Other names for a card that is listed anyway, converters and the like: "surround51", "dmix".
bool is_alias(std::string_view interface, std::string_view name);

// A position of PulseAudio's as a person calls it: "front left", "centre", "aux0".
std::vector<std::string> channel_names(const std::vector<std::string>& positions);

// A sound server behind an ALSA name.
bool is_sound_server(std::string_view interface, std::string_view name);

// "audio/ALSA/UMC204HD: USB Audio"; of several alike the second has " 2" after it, and so on.
std::string audio_id(std::string_view interface, std::string_view name, int which);

// Names of a card's `count` channels: loudspeakers in ALSA's order, and what is known of single
// models; "7" if a channel has no name. JACK numbers them.
std::vector<std::string> channel_names(std::string_view interface, std::string_view name,
                                       int count);

// What ALSA's configuration says of a name: whether it leads to a sound server, and whether there
// is a configuration at all.
//
// Left out  names that a plugin other than plug and asym leads on from.

// False: ALSA has none, or one without its usual names, and PortAudio would end the program over
// that.
bool has_alsa_configuration();

// The output of a PulseAudio server that a name leads to; empty: whichever that server takes
// usually. None: the name does not lead there, as far as is written down.
std::optional<std::string> server_output_behind(const std::string& name);

}  // namespace tact
