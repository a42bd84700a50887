#include <cmath>

#include "model/io/set/set_json.h"
#include "model/pattern/drawn_fault.h"
#include "model/pattern/pattern_numbers.h"
#include "model/pattern/rhythm_edit.h"
#include "model/text/described_json.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// The length of a step by its beat's tempo; of both, that of the step where they agree.
void read_tempo(JsonObject& fields, Rhythm& rhythm) {
    if (field(fields, "bpm") == nullptr) return;
    const int beat = rhythm.meter.steps_a_beat;
    const double own_bpm = tempo_bpm(rhythm.unit_s, beat);
    const Range units = numbers::kRhythmUnit.range;
    const double bpm = number_field(fields, "bpm", own_bpm,
                                    {tempo_bpm(units.high, beat), tempo_bpm(units.low, beat)});
    if (!fields.value->contains(numbers::kRhythmUnit.key)) {
        rhythm.unit_s = unit_at_tempo(bpm, beat);
    } else if (std::abs(bpm - own_bpm) > 1e-9 * own_bpm) {
        refuse(*fields.reading, place_of(fields, "bpm"),
               "either unit_s or bpm, or the " + shortest_digits(own_bpm) + " that unit_s makes",
               bpm);
    }
}

}  // namespace

void take_fields(JsonObject& fields, Rhythm& rhythm, Json& unknown) {
    rhythm.text = text_field(fields, "text", "");
    if (const std::string fault = rhythm_fault(rhythm.text); !fault.empty()) {
        refuse(*fields.reading, place_of(fields, "text"), "a rhythm (" + fault + ")", rhythm.text);
        rhythm.text.clear();
    }
    describe(Of<Rhythm>{}, TakeFields<Rhythm>{fields, rhythm, unknown});
    read_tempo(fields, rhythm);
}

void put_fields(Json& fields, const Rhythm& rhythm, const Rhythm* defaults) {
    fields["text"] = rhythm.text;
    describe(Of<Rhythm>{}, PutFields<Rhythm>{fields, rhythm, defaults});
}

Pattern pattern_of(JsonObject& object, double set_duration_s, Json& unknown) {
    Pattern pattern;
    pattern.duration_s = set_duration_s;
    take_fields(object, pattern, unknown);
    // Numbers have been looked at one by one; what is left are times and their order.
    if (const auto fault = drawn_fault(pattern)) {
        refuse(*object.reading, object.place + "/" + fault->place, fault->expected, fault->got);
    }
    return pattern;
}

Json json_of(const Pattern& pattern, double set_duration_s) {
    Pattern defaults;
    defaults.duration_s = set_duration_s;
    Json fields = Json::object();
    put_fields(fields, pattern, &defaults);
    return fields;
}

}  // namespace tact
