#include "model/io/recordings/waveform_csv.h"

#include <sstream>

namespace tact {

std::string waveform_csv(const Waveform& waveform) {
    std::ostringstream text;
    text.precision(17);
    text << "time_s,acceleration_g\n";
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        text << static_cast<double>(n) / waveform.rate_hz << ',' << waveform.samples_g[n] << '\n';
    }
    return text.str();
}

}  // namespace tact
