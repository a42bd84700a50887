#include "model/tasks/set_import.h"

#include <utility>

#include "model/text/utf8.h"

namespace tact {

Expected<ReadTwin> read_twin(const PatternSet& set, std::optional<std::size_t> place,
                             const std::filesystem::path& file,
                             std::span<const std::filesystem::path> files,
                             const AccelerationOptions& options) {
    const Vibration* intended = place ? &set.vibrations[*place] : nullptr;
    if (intended != nullptr && measures_another(*intended)) {
        return Error{in_quotes(intended->name) +
                     " is a measurement itself, expected the pattern that it measures"};
    }
    const auto recording = read_acceleration_file(file, options_among(file, files, options));
    if (!recording) return recording.error();
    ReadTwin read{{}, recording->remarks};
    if (intended == nullptr) return read;
    read.twin = measured_twin(*intended, recording->waveform);
    for (std::string& remark : remarks_on(read.twin->alignment)) {
        read.remarks.push_back(std::move(remark));
    }
    return read;
}

}  // namespace tact
