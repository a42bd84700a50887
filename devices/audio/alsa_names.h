// What ALSA's configuration says of a name: whether it leads to a sound server, and whether there
// is a configuration at all.
//
// Left out  names that a plugin other than plug and asym leads on from.
#pragma once

#include <optional>
#include <string>

namespace tact {

// False: ALSA has none, or one without its usual names, and PortAudio would end the program over
// that.
bool has_alsa_configuration();

// The output of a PulseAudio server that a name leads to; empty: whichever that server takes
// usually. None: the name does not lead there, as far as is written down.
std::optional<std::string> server_output_behind(const std::string& name);

}  // namespace tact
