// The formats of effects that other programs have: a row for each folder, with what it reads and
// what it writes.
//
// Order     that of the lists of what is written (target_formats, help, manual), and that in which
//           formats are asked whether a document is theirs (effect_format.h)
#pragma once

#include <array>
#include <span>

#include "model/io/formats/ahap/ahap.h"
#include "model/io/formats/android/android.h"
#include "model/io/formats/haps/haps.h"
#include "model/io/formats/haptic/haptic.h"
#include "model/io/formats/he/he.h"
#include "model/io/formats/hjif/hjif.h"
#include "model/io/formats/openxr/openxr.h"
#include "model/io/formats/pulsar/pulsar.h"
#include "model/io/formats/samples/samples.h"
#include "model/io/formats/vibrate/vibrate.h"

namespace tact {

struct FormatFolder {
    std::span<const EffectFormat> read;
    std::span<const TargetTraits> written;
};

inline constexpr auto kFormatFolders = std::to_array<FormatFolder>({
    {kHapticFormats, kHapticTargets},
    {kAhapFormats, kAhapTargets},
    {kHapsFormats, {}},
    {kHjifFormats, kHjifTargets},
    {kAndroidFormats, kAndroidTargets},
    {kVibrateFormats, kVibrateTargets},
    {kPulsarFormats, kPulsarTargets},
    {kHeFormats, kHeTargets},
    {{}, kOpenxrTargets},
    {{}, kSamplesTargets},
});

}  // namespace tact
